// Beads by their sections themselves, for what lies nearer to them than cells can tell.
#pragma once

#include "collision/shape_distance.h"
#include "geometry/box_grid.h"
#include "plan/tool_plan.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::collision {

// A bead's solid between two waypoints: a flat middle `along` from `start`, `halfFlat` to either
// side, grown by `radius`: its section is a rectangle with half-round sides.
struct BeadSection {
  Eigen::Vector3d start, along, side; // side: unit, across
  double halfFlat = 0.0, radius = 0.0;
};
// Precondition: i + 1 < plan.waypointCount().
BeadSection beadSection(const plan::ToolPlan& plan, std::size_t i);

// The distance of the disc to the bead's solid, at most 0 where they meet; the search ends as soon
// as it knows that. mm, to 1e-3.
double discDistance(const Disc& disc, const BeadSection& bead);

class BeadSections {
public:
  BeadSections() = default;
  // `segments`: the first waypoints of those that stay where they are laid, ascending.
  BeadSections(const plan::ToolPlan& plan, const std::vector<std::uint32_t>& segments);

  // Does the disc reach into a bead that is laid before the head is at waypoint `printing`? What
  // the path that is printed there laid over its last two widths is soft and does not count.
  // `normal` points away from the beads.
  bool reachedBy(const Disc& disc, std::size_t printing) const;

private:
  struct Place {
    std::uint32_t path = 0;
    float mm = 0.0f; // along it
    float softMm = 0.0f;
  };
  bool isSoft(std::size_t waypoint, std::size_t printing) const;

  std::vector<BeadSection> beads_;
  std::vector<std::uint32_t> laidAt_; // a bead: the waypoint that it leads to
  std::vector<Place> places_;         // a waypoint
  geometry::BoxGrid near_;
};

} // namespace voluta::collision
