// Makes printable layers from levels that follow a ground.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "layers/ground.h"
#include "layers/layer_checks.h"
#include "layers/layer_stack.h"
#include "layers/level_surface.h"
#include "plan/finding.h"

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace voluta::substrate {

struct LevelOptions {
  double layerHeightMm = 0.25, heightMinMm = 0.1, heightMaxMm = 0.35;
  double firstLayerMm = 0.0; // 0: as thick as the others
  double beadWidthMm = 0.7;
};

// Returns the outer bounds of levels of equal height between `from` and `to`, the inner one first.
// The height is the one nearest to the layer height for which the number of levels is an integer
// within the limits; the first level may have its own height. If no number of levels is within the
// limits, uses as many as the minimum height allows. Preconditions: from < to, positive heights.
std::vector<double> levelBounds(double from, double to, const LevelOptions& options);

// Return the edge length [mm] of levels, and that of the grid for offset levels, whose triangles
// are smaller than its cells.
double levelEdgeMm(const LevelOptions& options);
double offsetGridMm(const LevelOptions& options);

enum class GroundKind { Surface, Rod };

// A family of levels from a ground outwards.
struct LevelFamily {
  int count = 0;
  // Returns the mid-surface of the k-th level, not yet trimmed by the part. Called from many
  // threads at once.
  std::function<layers::LevelSurface(int k, const base::RunContext&)> level;
  layers::Ground ground; // The ground of the first levels
  // Returns the unit growth direction at a point.
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> outward;
  GroundKind groundKind = GroundKind::Surface; // How messages name the ground
  // The last levels end below slopes and steps of the part (layers::followTop()). False: the levels
  // are parallel to its surface.
  bool endsBelowSurface = true;
  // Modifies patches before slivers are absorbed; may be empty.
  std::function<void(std::vector<layers::Patch>&)> adapt;
};

struct StackedLevels {
  layers::LayerStack stack; // In print order
  plan::LayerStatistics statistics;
  std::size_t mergedPieces = 0;
  std::size_t slivers = 0; // Pieces of layers that are not printed
  double sliverVolumeMm3 = 0.0;
  std::size_t unsupportedPatches = 0; // Patches without support below
  plan::Findings findings;            // Stage "layers"
};

// Trims each level by the part; areas too small for a bead are absorbed by their neighbours, and
// the last layers below slopes and steps end on the surface (layers::followTop). `part`: closed,
// without the ground. Throws Error{UnusableInput} if no patch rests on the ground; throws
// Cancelled. The result is independent of the number of threads.
StackedLevels stackLevels(const geometry::TriangleMesh& part, const LevelFamily& family,
                          const LevelOptions& options, const base::RunContext& ctx);

} // namespace voluta::substrate
