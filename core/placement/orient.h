// Which way down: a search over orientations with a stated objective (docs/design.md, Stages).
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "placement/coarse_growth.h"
#include "placement/orientation_score.h"

#include <Eigen/Geometry>

namespace voluta::placement {

// orient (none, leastRisky, fewestMissed).
base::ParameterTable orientParameters();

enum class Objective { LeastRisky, FewestMissed };

struct OrientOptions {
  double voxelMm = 0.8;                    // width at which the part will be grown
  double overhangRad = 0.7853981633974483; // beyond which a facet is risky
  Eigen::Vector2d centreMm{0.0, 0.0};      // where the part's box is centred
  bool quarterTurns = false;               // only those
  std::size_t searchVoxels = 18000;        // of the coarse grid
  PlatformOf platform = {};
};

struct Orientation {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity(); // from how the mesh lies now
  OrientationScore score, before;                           // turned; as it lies
  std::size_t tried = 0;                                    // orientations that were compared
  // FewestMissed only. Voxels that one pass of reverse growth misses, at searchMm wide ...
  double searchMm = 0.0;
  std::size_t missed = 0, missedBefore = 0;
  std::size_t missedAtVoxelMm = 0; // ... and turned, at voxelMm
};

// The best way for `mesh` (mm) to lie. Compared are: as it lies; each of 26 directions (faces,
// edges and corners of a cube) down; its largest flat places down; and small turns from the best of
// these. Only orientations that stand (OrientationMeasure, contact within one voxel of the plate)
// are taken; where there is none, the part stays as it lies. Objectives:
//   LeastRisky: least risky area, then least height;
//   FewestMissed: fewest missed voxels, then least risky area, then least height; the best are
//   grown at full width too, and the first that misses nothing there is taken, else the best.
// A part that is as good as the best but for a quarter more risky area stays as it lies.
// Same result for any number of threads. Preconditions (Error{Internal}): mesh not empty, voxelMm
// > 0. Throws Error{Usage} as voxel::solidVoxels(); Cancelled.
Orientation bestOrientation(const geometry::TriangleMesh& mesh, Objective objective,
                            const OrientOptions& options, const base::RunContext& ctx);

} // namespace voluta::placement
