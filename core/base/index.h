// Converts indices that files and meshes store as int for use with containers.
#pragma once

#include <cstddef>

namespace voluta::base {

// Precondition, not checked: i >= 0.
constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

} // namespace voluta::base
