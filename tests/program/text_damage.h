// Damage to the text of a program, the same for every dialect: places to change are found by
// reading the changed text with the dialect's own reader, so that the text stays one that a
// controller would run.
#pragma once

#include "plan/program.h"
#include "process/tooling.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::test {

// The first file of a program, line by line without their ends; of frames (TMscript) the statement,
// which read() frames anew.
struct ProgramText {
  std::string format; // id of its dialect
  std::string name;
  std::vector<std::string> lines;
};
ProgramText textOf(const plan::Program& program);
plan::ReadProgram read(const ProgramText& text, const process::Process& process);
plan::ReadProgram read(const ProgramText& text, const process::Tooling& tooling);

// Positions of numbers in a line: first character, and the one behind the last.
std::vector<std::pair<std::size_t, std::size_t>> numbersIn(std::string_view line);
// The line with the number there replaced.
std::string withNumber(const std::string& line, std::pair<std::size_t, std::size_t> where,
                       double value);

// Both motions go to the same place in the same way, whatever their speed and material.
bool sameTarget(const plan::ProgramMotion& a, const plan::ProgramMotion& b);
bool sameMotion(const plan::ProgramMotion& a, const plan::ProgramMotion& b);

// Each changes the text at motion `motion` and returns the line (1-based) of the damage; nothing
// where no such change can be read. The text has no defects before and after, except for an amount
// that falls again behind the travel, and a point that its own velocity does not lead to. Its
// target is about 2 mm beside the former one.
std::optional<std::size_t> moveTarget(ProgramText& text, std::size_t motion,
                                      const process::Process& process);
// It takes a tenth of its time.
std::optional<std::size_t> tenfoldSpeed(ProgramText& text, std::size_t motion,
                                        const process::Process& process);
// The next travel behind it lays material.
std::optional<std::size_t> extrudeOverTravel(ProgramText& text, std::size_t motion,
                                             const process::Process& process);

} // namespace voluta::test
