// Exact bead sections, for collision checks at distances that the grid does not resolve.
#pragma once

#include "collision/shape_distance.h"
#include "geometry/box_grid.h"
#include "plan/tool_plan.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::collision {

// Solid of a bead between two waypoints: a flat strip `along` from `start`, `halfFlat` to either
// side, grown by `radius`: its section is a rectangle with half-round sides.
struct BeadSection {
  Eigen::Vector3d start, along, side; // side: unit, across
  double halfFlat = 0.0, radius = 0.0;
};
// Precondition: i + 1 < plan.waypointCount().
BeadSection beadSection(const plan::ToolPlan& plan, std::size_t i);

// Returns the distance of the disc from the bead's solid, at most 0 if they intersect; the search
// then stops early. mm, to 1e-3.
double discDistance(const Disc& disc, const BeadSection& bead);

class BeadSections {
public:
  BeadSections() = default;
  // `segments`: first waypoints of the segments that stay where they are printed, ascending.
  BeadSections(const plan::ToolPlan& plan, const std::vector<std::uint32_t>& segments);

  // Returns whether the disc reaches into a bead that is printed before the head is at waypoint
  // `printing`. The last two bead widths of the path printed there are soft and do not count.
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
  std::vector<std::uint32_t> printedAt_; // per bead: its end waypoint
  std::vector<double> topMm_;            // per bead: the greatest z of it and all earlier ones
  std::vector<Place> places_;            // per waypoint
  geometry::BoxGrid near_;
};

} // namespace voluta::collision
