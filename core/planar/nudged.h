// A plane where a section closes, at a height or as near to it as there is one.
#pragma once

#include "base/error.h"

#include <array>
#include <type_traits>
#include <utility>

namespace voluta::planar {

// The section of a mesh by a plane, which crosses itself.
[[noreturn]] inline void sectionCrosses() {
  throw base::Error(base::ErrorCode::UnusableInput,
                    "the section of the mesh by a plane crosses itself"_text, {},
                    "repair the mesh, or use curved mode, which takes any mesh"_text);
}

// What `tryAt(offset)`, which returns an optional, gives first, tried at the offset itself and up
// to 1e-4 mm from it; where it gives nothing, what `otherwise()` gives.
template <typename Try, typename Otherwise>
auto atOrNear(double offsetMm, Try&& tryAt, Otherwise&& otherwise) {
  constexpr std::array<double, 9> kMoved{0.0, 1e-7, -1e-7, 1e-6, -1e-6, 1e-5, -1e-5, 1e-4, -1e-4};
  for (const double moved : kMoved)
    if (auto found = tryAt(offsetMm + moved))
      return std::move(*found);
  return otherwise();
}

// The same; throws Error{UnusableInput} where it gives nothing.
template <typename Try> auto atOrNear(double offsetMm, Try&& tryAt) {
  using Found = std::remove_cvref_t<decltype(*tryAt(offsetMm))>;
  return atOrNear(offsetMm, std::forward<Try>(tryAt), []() -> Found { sectionCrosses(); });
}

} // namespace voluta::planar
