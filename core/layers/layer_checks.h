// Measurements on layers of any mode.
#pragma once

#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "layers/ground.h"
#include "layers/layer_stack.h"
#include "plan/statistics.h"

#include <limits>
#include <vector>

namespace voluta::layers {

struct HeightLimits {
  double minMm = 0.0, maxMm = std::numeric_limits<double>::infinity();
};
plan::LayerStatistics layerStatistics(const LayerStack& stack, const HeightLimits& limits = {});

// Boundary check for tests; each entry is for the patch of the same index.
struct BoundaryCheck {
  double farthestMm = 0.0; // largest distance of a boundary vertex from the part's surface
  double onSurface = 1.0;  // share of the boundary's length whose ends are within the tolerance
  // every boundary vertex has two boundary edges; edges have <= 2 sides with opposite orientations
  bool simple = true;
};
std::vector<BoundaryCheck> checkBoundaries(const LayerStack& stack, const geometry::MeshQuery& part,
                                           double toleranceMm, const base::RunContext& ctx);

// Result of the search for the ground or an earlier patch below a patch. At sampled triangles the
// foot (half a thickness against the direction) must be within reachShare of the two half
// thicknesses, and at least half of that distance downwards.
struct SupportCheck {
  double supportedFraction = 1.0; // of the area
  int lower = -1;                 // index of a patch below it (the most frequent one), -1: ground
  Eigen::Vector3d unsupportedAt = Eigen::Vector3d::Zero(); // an unsupported place, if any
};
// Checks the patches `which` (ascending); empty: all.
std::vector<SupportCheck> checkSupport(const LayerStack& stack, double reachShare,
                                       const base::RunContext& ctx,
                                       const std::vector<std::size_t>& which = {},
                                       const Ground& ground = {});

} // namespace voluta::layers
