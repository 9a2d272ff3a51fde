// Lines that the user asked for before a layer: the setting of an output (EventKind::Output), and
// statements of his own (EventKind::Statement). A remark marks each, so that a reader knows them
// without the plan. A dialect's writer and reader see them as remarks.
#pragma once

#include "plan/program.h"
#include "plan/stated_facts.h"
#include "plan/trajectory.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// How a language sets a digital output; {} stands for its number.
struct OutputWords {
  std::string_view on = {}, off = {};
  std::string_view name =
      {};                   // occurs in every line that uses the output; empty: no other line does
  int first = 0, last = -1; // numbers of outputs; none if last < first
  // A line of its own before the mark, without which the controller runs ahead of the arm; empty:
  // it does not.
  std::string_view settles = {};
};

inline constexpr std::string_view kGcodeSettles = "M400", kKrlSettles = "WAIT SEC 0",
                                  kTmSettles = "QueueTag(1,1)";

// Returns those of a dialect; without numbers if it sets none.
OutputWords outputWords(std::string_view dialect);

// The remark before each such line.
inline constexpr std::string_view kOwnLineMark = "asked for before this layer:";
// Returns the line of an event. Precondition: the dialect has words for it (requireOwnLine).
std::string ownLine(std::string_view dialect, const plan::TrajectoryEvent& event);
// Throws Error{Usage} if the dialect has no such output, or if the statement is for another format
// and there is none for this one before the same point of the trajectory, or if it has a word that
// it must not have (refused_statements.h).
void requireOwnLine(std::string_view dialect, const plan::TrajectoryEvent& event,
                    const plan::Trajectory& trajectory);
// Returns the trajectory without the statements for other formats; itself if it has none of them.
std::shared_ptr<const plan::Trajectory>
withOwnStatements(std::string_view dialect, std::shared_ptr<const plan::Trajectory> trajectory);

// Returns the remark that stands for a line until uncoverOwnLines().
std::string ownLineRemark(std::string_view line);
// Replaces these remarks by their lines. Throws Error{Usage} if another line of the program uses an
// output or a variable that one of them sets.
void uncoverOwnLines(std::vector<plan::ProgramFile>& files, std::string_view dialect,
                     std::string_view remark, const std::vector<plan::TrajectoryEvent>& events);

// The marked lines of a text, and the files in which remarks stand for them.
struct ReadOwnLines {
  std::vector<plan::ProgramFile> files; // empty if there are none
  std::vector<plan::StatedFact> facts;  // OwnStatement; without the next motion
  // Lines that run ahead of the arm (OutputWords::settles).
  std::vector<plan::ProgramDefect> defects;
};
ReadOwnLines takeOwnLines(const std::vector<plan::ProgramFile>& files, std::string_view dialect,
                          std::string_view remark);

} // namespace voluta::program
