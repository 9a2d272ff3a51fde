// From levels that follow a ground to the layers that are laid.
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

// Outer bounds of levels of equal height between two, the inner one first; the height is the
// nearest to the wanted one for which they are a whole number, the first one's its own. Where no
// number of levels is within the limits, the part's surface takes what is left.
// Precondition: from < to, positive heights.
std::vector<double> levelBounds(double from, double to, const LevelOptions& options);

// Edges of levels, mm; and of the grid of those at a distance, whose triangles are smaller than its
// cells.
double levelEdgeMm(const LevelOptions& options);
double offsetGridMm(const LevelOptions& options);

enum class GroundKind { Surface, Rod };

// Levels from a ground outwards.
struct LevelFamily {
  int count = 0;
  // The k-th's mid-surface, not yet cut by the part. Called from many threads at once.
  std::function<layers::LevelSurface(int k, const base::RunContext&)> level;
  layers::Ground ground; // what the first ones lie on
  // Unit: the way material grows at a point.
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> outward;
  GroundKind groundKind = GroundKind::Surface; // what it is called
  // Changes patches before slivers are shared out; may be empty.
  std::function<void(std::vector<layers::Patch>&)> adapt;
};

struct StackedLevels {
  layers::LayerStack stack; // in print order
  layers::LayerStatistics statistics;
  std::size_t mergedPieces = 0;
  std::size_t slivers = 0; // pieces of layers that are not laid
  double sliverVolumeMm3 = 0.0;
  std::size_t unsupportedPatches = 0; // that begin in the air
  plan::Findings findings;            // stage "layers"
};

// Each level trimmed by the part, what is too small for a bead taken by its neighbours, last layers
// under slopes and steps ending on the surface (layers::followTop). `part`: closed, less the
// ground. Throws Error{UnusableInput} where nothing of it lies on the ground; Cancelled. Same
// result for any number of threads.
StackedLevels stackLevels(const geometry::TriangleMesh& part, const LevelFamily& family,
                          const LevelOptions& options, const base::RunContext& ctx);

} // namespace voluta::substrate
