// What the regions of a part say about its supports.
#pragma once

#include "geometry/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace voluta::layers {

enum class SupportRule : std::uint8_t {
  None,  // never: a blocker
  Auto,  // where a layer or the growth needs it
  Always // under every overhang: an enforcer
};

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
