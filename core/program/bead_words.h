// Statements of a process at the starts and ends of beads (process::BeadWords) in programs. A
// dialect's writer and reader see them as remarks.
#pragma once

#include "plan/finding.h"
#include "plan/program.h"
#include "plan/stated_facts.h"
#include "process/tooling.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Returns the remark by which a writer marks the place of a statement.
std::string beadWordRemark(std::string_view statement);

// Replaces these remarks by their statements. `remark`: prefix of the dialect's comments.
void uncoverBeadWords(std::vector<plan::ProgramFile>& files, std::string_view remark);

// Returns the part of a line behind its indentation and its number, if it has one.
std::string_view codeOfLine(std::string_view line);

// Throws Error{Usage} if a tool's process has statements, but none for the format: its beads need
// them, unless they only press with a force.
void requireBeadWords(std::string_view format, const process::Tooling& tooling);

// Returns the finding "withoutForce" if a tool's process presses with a force in other formats.
std::optional<plan::Finding> withoutForce(std::string_view format, const process::Tooling& tooling);

// The statements of a text, and the files in which they are remarks.
struct ReadBeadWords {
  std::vector<plan::ProgramFile> files; // empty if the tools have no statements for the format
  std::vector<plan::StatedFact> facts;  // BeadStartWord, BeadEndWord; without the next motion
};
// Finds the lines that consist of a statement of one of the tools, behind a line number if any.
ReadBeadWords takeBeadWords(const std::vector<plan::ProgramFile>& files, std::string_view format,
                            std::string_view remark, const process::Tooling& tooling);

// Sets StatedFact::before from the places of the motions, and adds the facts to the program.
void addBeadWords(std::vector<plan::StatedFact> facts, plan::ReadProgram& program);

} // namespace voluta::program
