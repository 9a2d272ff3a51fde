// Damage to the lines of events in a program, the same for every dialect: some thirty kinds, each
// at every line that it fits.
#pragma once

#include "program/text_damage.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace voluta::test {

// Lines of a stop between two motions, from 0: first, and the one behind the last.
struct EventBlock {
  std::size_t first = 0, end = 0;
};

struct EventDamage {
  std::string kind;
  ProgramText text;
  std::string line; // that is damaged
};

// Returns the damage to the blocks of a program. `motions`: lines of its motions, from 0.
std::vector<EventDamage> eventDamage(const ProgramText& whole,
                                     const std::vector<EventBlock>& blocks,
                                     const std::vector<std::size_t>& motions);

} // namespace voluta::test
