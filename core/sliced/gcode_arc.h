// Arcs of G2 and G3 in the plane of x and y.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace voluta::sliced {

struct GcodeArc {
  Eigen::Vector3d from, to; // [mm]; z changes evenly along the arc
  bool clockwise = false;
  std::optional<Eigen::Vector2d> toCentre; // I and J: from the start
  std::optional<double> radiusMm;          // R; negative: the longer way round
};

// Returns points at equal distances along the arc, the last one its end, such that chords are
// within 0.005 mm of it. A whole circle if both ends coincide and its centre is given. nullopt if
// there is no such arc, or its end is farther than 0.05 mm (and 1 % of the radius) from the circle.
std::optional<std::vector<Eigen::Vector3d>> pointsOf(const GcodeArc& arc);

} // namespace voluta::sliced
