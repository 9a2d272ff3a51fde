// What can be measured on layers of any mode.
#pragma once

#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "layers/ground.h"
#include "layers/layer_stack.h"

#include <limits>
#include <vector>

namespace voluta::layers {

// report.json, "layers". Area-weighted, so that areaMm2 * thicknessMeanMm is the volume. Supports
// apart.
struct LayerStatistics {
  int count = 0; // layers, also those of supports alone
  std::size_t patches = 0;
  double areaMm2 = 0.0;
  double thicknessMeanMm = 0.0, thicknessStdMm = 0.0, thicknessP01Mm = 0.0, thicknessP99Mm = 0.0;
  double withinLimitsFraction = 1.0; // share of the area whose thickness is within the limits

  double volumeMm3() const { return areaMm2 * thicknessMeanMm; }
};
struct HeightLimits {
  double minMm = 0.0, maxMm = std::numeric_limits<double>::infinity();
};
LayerStatistics layerStatistics(const LayerStack& stack, const HeightLimits& limits = {});

// A checker for tests: each entry is for the patch of the same index.
struct BoundaryCheck {
  double farthestMm = 0.0; // of a boundary vertex from the part's surface
  double onSurface = 1.0;  // share of the boundary's length whose ends are within the tolerance
  bool simple = true;      // every boundary vertex has two boundary edges; edges have <= 2 sides,
                           // which run opposite ways
};
std::vector<BoundaryCheck> checkBoundaries(const LayerStack& stack, const geometry::MeshQuery& part,
                                           double toleranceMm, const base::RunContext& ctx);

// What is under a patch: the ground, or an earlier patch. At sampled triangles the foot (half
// a thickness against direction) is within reachShare of the two half thicknesses, and half of them
// lower at least.
struct SupportCheck {
  double supportedFraction = 1.0; // of the area
  int lower = -1;                 // index of a patch under it (the one met most often), -1: ground
  Eigen::Vector3d unsupportedAt = Eigen::Vector3d::Zero(); // a place without support, if any
};
// Of `which` patches (ascending); empty stands for all.
std::vector<SupportCheck> checkSupport(const LayerStack& stack, double reachShare,
                                       const base::RunContext& ctx,
                                       const std::vector<std::size_t>& which = {},
                                       const Ground& ground = {});

} // namespace voluta::layers
