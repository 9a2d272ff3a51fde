// The job information in a program's head, identical in every dialect, and the sanitizing of texts
// from files for comments and strings.
#pragma once

#include "plan/program.h"
#include "plan/trajectory.h"
#include "program/program_input.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Returns `text` in a form valid in a comment or quoted string of any dialect: as
// base::asciiText(), with '_' for quotes, backslashes and line ends too, at most `maxLength`
// characters.
std::string plainText(std::string_view text, std::size_t maxLength = 60);

// Returns 16 hexadecimal digits that identify the motion and the machine: joints, times, material
// and kinds of the motions, cell, robot and process. Programs of the same motion have the same hash
// in every dialect (ProgramInput::job).
std::string jobHash(const ProgramInput& input);

// Returns the plate's temperature [C], for which the first of the materials decides that the whole
// job uses: the rest of a stopped print keeps the plate as it is. 0: not heated.
int plateC(const ProgramInput& input);

// Begins the line of a head with the verdict of the replay.
inline constexpr std::string_view kVerdictMark = "replay: ";
// Replaces the verdict in the heads of all files, as a comment of the same line: nothing else of
// the texts changes. The verdict is cut where the line would be longer than the dialect allows.
// Returns whether there is such a line in a head.
bool replaceVerdict(std::vector<plan::ProgramFile>& files, std::string_view verdict,
                    std::size_t longestLine);

// Returns lines without a dialect's comment mark: part, job, cell, robot, process; the verdict, if
// there is one; amount and duration; temperatures and fan, if known; the ranges and the start
// values of the joints (unless foreign: those of the cell's own arm); how programs with marks are
// started.
std::vector<std::string> headLines(const ProgramInput& input);
// Same for controllers that limit lines to `maxLength` characters: longer lines are continued in
// the next one at a blank; lines that names from files make too long are cut.
std::vector<std::string> headLines(const ProgramInput& input, std::size_t maxLength);

// A program's origin as stated in its head: the inverse of headLines. Missing fields are empty.
struct JobHead {
  std::string part, job, cell, robot, process;
  friend bool operator==(const JobHead&, const JobHead&) = default;
};
JobHead jobHead(const ProgramInput& input);
// A head ends within this many lines from a file's beginning.
inline constexpr std::size_t kHeadLines = 60;
// Returns the text after `word` at the start of a comment; only marks may precede it.
std::optional<std::string_view> behindMark(std::string_view line, std::string_view word);

// Returns the information in the first lines of the files; nullopt if none names a job: a program
// from another source, or with its comments removed.
std::optional<JobHead> readJobHead(const std::vector<plan::ProgramFile>& files);

// Returns whether the program cuts tape, for which a head names the output.
bool cutsTape(const ProgramInput& input);

// Returns whether the program has an output that locks the tool of a tool changer.
bool locksTool(const ProgramInput& input);

// Returns the text shown at a planned pause that is for no change of the tool, at most
// kQuestionLength characters.
std::string pauseText(const plan::TrajectoryEvent& pause);
// Returns e.g. "tool 2 (petg-1.0, PETG, 240 C)"; long names are cut.
std::string toolName(const process::Tooling& tooling, int tool);
// Message for the operator at a tool change by hand, e.g. "Fit tool 2 (petg-1.0, PETG, 240 C),
// then continue".
std::string changeText(const process::Tooling& tooling, int tool);
// Returns the names of the outputs of the tools but the first, and of the tool changer's; none if
// the job has one tool. `output`: returns the name of an output by its number.
std::vector<std::string> toolOutputs(const ProgramInput& input,
                                     const std::function<std::string(int)>& output);
// What the program's outputs select, e.g. "tool 2 (petg-1.0, PETG, 240 C): digital output 1", one
// line for each tool but the first, all of whose outputs are off; none if the job has one
// tool. `output`: the name of the output of a tool's index.
std::vector<std::string> toolNotes(const ProgramInput& input,
                                   const std::function<std::string(int)>& output);
// Question to the operator before anything moves.
inline constexpr std::string_view kStartQuestion =
    "The arm goes slowly and straight to its start. Is the way clear?";

// The same with the temperatures that the operator has to set, as far as they are known, for
// programs that cannot heat and wait; in a job of several tools it names the first one with its
// material and temperature. At most kQuestionLength characters.
std::string startQuestion(const ProgramInput& input);
inline constexpr std::size_t kQuestionLength = 80; // RAPID's strings
// Returns the beginning of a question about the first tool, e.g. "Is tool 1 (fdm-1.0, PLA, 210 C)
// fitted".
std::string fittedQuestion(const ProgramInput& input);

} // namespace voluta::program
