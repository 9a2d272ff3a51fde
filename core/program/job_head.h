// What the head of a program says of its job, the same in every dialect, and the one way in which
// text from files gets into comments and strings.
#pragma once

#include "plan/program.h"
#include "program/program_input.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// `text` as one piece of a comment or a quoted string of any dialect: printable ASCII without
// quotes, backslashes and line ends (each becomes '_'), at most `most` characters.
std::string plainText(std::string_view text, std::size_t most = 60);

// 16 hexadecimal digits of what is printed and with which machine: joints, times, material and
// kinds of the motions, cell, robot and process. Programs of the same motion have the same, in
// whatever dialect (ProgramInput::job).
std::string jobHash(const ProgramInput& input);

// Lines without a dialect's mark for remarks: part, job, cell, robot, process; how much, how long;
// between which values the joints go (unless foreign: of the cell's own arm) and where it starts.
std::vector<std::string> headLines(const ProgramInput& input);
// The same for controllers whose lines hold at most `most` characters: a longer one goes on in the
// next, at a blank; what names from files make too long is cut.
std::vector<std::string> headLines(const ProgramInput& input, std::size_t most);

// Where a program is from, as its head says it: headLines read back. A field that the head does not
// have is empty.
struct JobHead {
  std::string part, job, cell, robot, process;
  friend bool operator==(const JobHead&, const JobHead&) = default;
};
JobHead jobHead(const ProgramInput& input);
// A head ends within so many lines of a file's beginning.
inline constexpr std::size_t kHeadLines = 60;
// What follows `word`, which begins a remark's text: before it are marks only.
std::optional<std::string_view> behindMark(std::string_view line, std::string_view word);

// What the first lines of the files say; nothing where none names a job: a program of another
// origin, or one whose remarks were taken out.
std::optional<JobHead> readJobHead(const std::vector<plan::ProgramFile>& files);

// Asked of the operator before anything moves.
inline constexpr std::string_view kPauseText = "Paused. Continue?"; // at a planned pause
inline constexpr std::string_view kStartQuestion =
    "The arm goes slowly and straight to its start. Is the way clear?";

} // namespace voluta::program
