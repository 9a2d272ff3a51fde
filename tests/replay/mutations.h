// Edits of programs' texts: harmful ones, each named, and harmless ones, the same for every dialect
// except for its own words.
#pragma once

#include "plan/program.h"
#include "process/process.h"
#include "program/text_damage.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace voluta::test {

// A text that is to be damaged at a motion within a bead, and the program that its reader read.
struct Subject {
  ProgramText text;
  plan::ReadProgram read;
  const process::Process& process;
};

struct Mutation {
  std::string kind;
  // Changes the text at or near motion `m`; the line (1-based) of the damage, or nothing where this
  // place has no such thing to damage.
  std::function<std::optional<std::size_t>(Subject&, std::size_t m, std::mt19937_64& random)> apply;
};

std::vector<Mutation> harmfulMutations(const std::string& format);
std::vector<Mutation> harmlessMutations(const std::string& format);

} // namespace voluta::test
