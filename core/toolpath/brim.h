// The brim: loops on the plate around the first layer, which keep it from lifting. They are printed
// first and broken off after printing.
#pragma once

#include "layers/layer_stack.h"
#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "toolpath/options.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace voluta::toolpath {

using Polygon2d = std::vector<Eigen::Vector2d>; // The first point is not repeated

struct BrimLoop {
  std::vector<Eigen::Vector2d> points; // Centreline; a closed one does not repeat its first point
  bool closed = true;
};
struct Brim {
  std::vector<BrimLoop> loops;               // In print order, from the outermost inwards
  double lengthMm = 0.0;                     // Of the loops
  double cutMm = 0.0;                        // Length of the loops that was cut off at the plate
  std::optional<Eigen::Vector2d> cutAt = {}; // A point of it
};

struct BrimBead {
  double hatchMm = 0.0; // Distance of neighbouring loops
  double widthMm = 0.0;
};

// Returns the loops around polygons and supports (counter-clockwise, holes clockwise; overlaps
// count once) on a plate (convex, counter-clockwise): round(brimWidthMm / hatch), at least one, at
// (k + 1/2) hatches from the outlines. Loops of islands that are nearer than two brims to each
// other are joined. Holes and pockets between islands get none. A polygon inside a hole has loops
// too, a hatch away from the hole's wall; supports there have none. What lies beyond the plate's
// edge is cut off.
Brim brimAround(const std::vector<Polygon2d>& polygons, const Polygon2d& plate, double brimWidthMm,
                const BrimBead& bead, const std::vector<Polygon2d>& supports = {});

// Puts the brim before all other paths, printed with the first tool as PathKind::Skirt. Surrounds
// what the plan's patches and supports have below three quarters of its height. Does nothing if the
// width is 0, the plan has no path, or the platform is no plate. Returns a finding with the place
// if a part of the brim is cut off at the plate's edge.
std::optional<plan::Finding> addBrim(plan::ToolPlan& plan, const layers::LayerStack& stack,
                                     const process::Tooling& tooling,
                                     const ToolpathOptions& options);

} // namespace voluta::toolpath
