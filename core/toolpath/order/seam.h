// Kinds of seams, that is, of where closed walls begin and end: one row each.
#pragma once

#include "base/text.h"
#include "toolpath/coverage/bead.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace voluta::toolpath {

// A place on a bead: `share` of the way from points[segment] to the next one.
struct SeamPlace {
  std::size_t segment = 0;
  double share = 0.0; // [0, 1)
};

struct SeamInput {
  const Bead& bead; // closed; the material is to its left, seen from the nozzle
  int layer = 0;
  std::size_t path = 0; // counts the closed walls of the layer
  // Tips at the seams of the layers before, of walls of the same ring.
  std::span<const Eigen::Vector3d> below;
};

struct SeamKind {
  std::string_view id;
  base::Text label;
  // Returns the place where the wall begins and ends. Null: wherever the travel is shortest.
  SeamPlace (*place)(const SeamInput&) = nullptr;
};
// Returns all kinds; the first is the default.
std::span<const SeamKind> seamKinds();
// Throws Error{Usage} for an unknown id, suggesting the nearest.
const SeamKind& seamKind(std::string_view id);

// The place nearest to a seam below, if one is within two bead widths; otherwise the furthest in a
// fixed direction of the work frame: y, or z or x if the bead hardly extends along y.
SeamPlace alignedSeam(const SeamInput& input);
// The sharpest corner that points into the material, otherwise the sharpest that points out of it,
// otherwise alignedSeam(). Of corners about equally sharp, the one that alignedSeam() prefers.
SeamPlace cornerSeam(const SeamInput& input);
// Anywhere on the bead, with equal chances for equal lengths. Depends on layer and path only.
SeamPlace spreadSeam(const SeamInput& input);

// Returns the place nearest to a seam below, if one is within two bead widths; otherwise the
// furthest in the fixed direction of alignedSeam(). Precondition: there are places.
SeamPlace preferredSeam(const SeamInput& input, std::span<const SeamPlace> places);

constexpr double kSameSeamMm = 0.1; // no point is added so close to another
// Returns the nozzle tip at a place.
Eigen::Vector3d tipAt(const Bead& bead, const SeamPlace& place);
// Returns where a bead begins that is to begin at a place: at a point within kSameSeamMm, if there
// is one.
SeamPlace begunPlace(const Bead& bead, const SeamPlace& place);
// Returns the closed bead, begun at begunPlace(), with a point there.
Bead begunAt(const Bead& bead, const SeamPlace& place);

} // namespace voluta::toolpath
