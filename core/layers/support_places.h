// What the regions of a part say about its supports.
#pragma once

#include "geometry/triangle_mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::layers {

enum class SupportRule : std::uint8_t {
  None,   // never: a blocker
  Auto,   // where a layer or the growth needs it
  Always, // under every overhang: an enforcer
  Carried // by what is put in there: nothing hangs, and there is no room for a column
};
inline constexpr std::size_t kSupportRules = 4;
constexpr bool wantsColumns(SupportRule rule) {
  return rule == SupportRule::Auto || rule == SupportRule::Always;
}

// A place with a rule of its own.
struct SupportPlace {
  SupportRule rule = SupportRule::Auto;
  geometry::TriangleMesh body; // closed, work frame
};

struct SupportPlaces {
  std::vector<SupportPlace> places; // where two overlap, the later one holds
  // Closed, work frame: printed after the supports, which keep clear of them.
  std::vector<geometry::TriangleMesh> printedLater;

  bool empty() const { return places.empty() && printedLater.empty(); }
};

} // namespace voluta::layers
