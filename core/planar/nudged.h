// Retries at slightly moved planes, for sections that do not close at the exact height.
#pragma once

#include "base/error.h"

#include <array>
#include <type_traits>
#include <utility>

namespace voluta::planar {

// Throws the error for a mesh whose section by a plane crosses itself.
[[noreturn]] inline void sectionCrosses() {
  throw base::Error(base::ErrorCode::UnusableInput,
                    "a planar section of the mesh crosses itself"_text, {},
                    "repair the mesh, or use curved mode, which takes any mesh"_text);
}

// Returns the first value that `tryAt(offset)` (returning an optional) yields at the offset itself
// or at up to 1e-4 mm from it; if there is none, returns `otherwise()`.
template <typename Try, typename Otherwise>
auto atOrNear(double offsetMm, Try&& tryAt, Otherwise&& otherwise) {
  constexpr std::array<double, 9> kMoved{0.0, 1e-7, -1e-7, 1e-6, -1e-6, 1e-5, -1e-5, 1e-4, -1e-4};
  for (const double moved : kMoved)
    if (auto found = tryAt(offsetMm + moved))
      return std::move(*found);
  return otherwise();
}

// Same, but throws Error{UnusableInput} if there is no value.
template <typename Try> auto atOrNear(double offsetMm, Try&& tryAt) {
  using Found = std::remove_cvref_t<decltype(*tryAt(offsetMm))>;
  return atOrNear(offsetMm, std::forward<Try>(tryAt), []() -> Found { sectionCrosses(); });
}

} // namespace voluta::planar
