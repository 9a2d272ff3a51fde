// The suite takes a few of a test's random cases; packaging/check takes all of them.
#pragma once

#include <cstdlib>

namespace voluta::test {

// Returns whether VOLUTA_ALL_SEEDS is set.
inline bool allSeeds() {
  return std::getenv("VOLUTA_ALL_SEEDS") != nullptr;
}

// Returns `all` if VOLUTA_ALL_SEEDS is set, otherwise `few`.
template <typename Count> Count ofSeeds(Count few, Count all) {
  return allSeeds() ? all : few;
}

} // namespace voluta::test
