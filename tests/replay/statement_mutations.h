// Edits of the statements of a program between its motions: changes of tools, purges, cuts, shots,
// marks, heat, waits, stops. Each is harmful: harmless ones are left out.
#pragma once

#include "plan/program.h"
#include "program/text_damage.h"

#include <cstddef>
#include <string>
#include <vector>

namespace voluta::test {

struct StatementEdit {
  std::string kind;
  ProgramText text;
  std::size_t first = 0, last = 0; // lines, from 1, between which it should be found
};

// Drops, doubles and exchanges with the next one each statement, moves it past motions, and gives
// each of its numbers the other sign and 1.3 times its value.
std::vector<StatementEdit> statementEdits(const ProgramText& whole, const plan::ReadProgram& read);

} // namespace voluta::test
