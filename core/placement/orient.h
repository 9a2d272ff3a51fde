// Search for the orientation of a part with a given objective (docs/design.md, Stages).
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "placement/coarse_growth.h"
#include "placement/orientation_score.h"
#include "placement/residual_area.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <optional>

namespace voluta::placement {

// Returns the parameter orient (none, leastRisky, fewestMissed, leastResidual, leastAfterCuts,
// leastTension).
base::ParameterTable orientParameters();

enum class Objective { MinRiskyArea, FewestMissed, MinResidualArea, MinAfterCuts, LeastTension };

// What remains of a part's risky area if it is cut into pieces.
struct CutOutcome {
  double riskyMm2 = 0.0;
  std::size_t pieces = 1;
};
// Returns the result for the part rotated by `rotation` and placed on the plate. Called on several
// threads.
using CutOutcomeOf = std::function<CutOutcome(const Eigen::Quaterniond& rotation)>;

// Returns what the cuts really leave, as they are planned; nullopt if the part cannot be cut in
// that orientation.
using CheckedCutsOf = std::function<std::optional<CutOutcome>(const Eigen::Quaterniond& rotation)>;

// Returns the tension across layers perpendicular to a unit direction of the mesh [MPa].
using TensionOf = std::function<double(const Eigen::Vector3d& up)>;

struct OrientOptions {
  double voxelMm = 0.8;                    // voxel width for growing the part
  double overhangRad = 0.7853981633974483; // facets beyond it are risky
  Eigen::Vector2d centreMm{0.0, 0.0};      // centre of the part's bounding box
  bool quarterTurns = false;               // true: quarter turns only
  std::size_t searchVoxels = 18000;        // of the coarse grid
  PlatformOf platform = {};
  CutOutcomeOf cutOutcome = {};   // required by MinAfterCuts
  CheckedCutsOf checkedCuts = {}; // empty: cutOutcome decides
  TensionOf tension = {};         // required by LeastTension
};

struct Orientation {
  // Relative to the mesh's present orientation
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  OrientationScore score, before; // rotated; present
  std::size_t tried = 0;          // number of orientations compared
  // FewestMissed only: voxels that one pass of reverse growth misses, at a width of searchMm ...
  double searchMm = 0.0;
  std::size_t missed = 0, missedBefore = 0;
  std::size_t missedAtVoxelMm = 0;                 // ... and rotated, at voxelMm
  ResidualAreas residual, residualBefore;          // MinResidualArea only
  CutOutcome cuts, cutsBefore;                     // MinAfterCuts only
  bool areCutsChecked = false;                     // `cuts` is of OrientOptions::checkedCuts
  double tensionMPa = 0.0, tensionBeforeMPa = 0.0; // LeastTension only
};

// Returns the best orientation of `mesh` (mm). Compares the present one; each of 26 directions
// (faces, edges and corners of a cube) down; its largest flat places down; and small rotations from
// the best of these. Considers only orientations in which the part stands (OrientationMeasure,
// contact within one voxel of the plate); if there is none, the part stays as it is. Objectives:
//   MinRiskyArea: minimum risky area, then minimum height;
//   FewestMissed: fewest missed voxels, then minimum risky area, then minimum height; the best are
//   also
//   grown at full width, and the first that misses nothing is chosen, else the best. The present
//   orientation is kept if it misses no more voxels than the best one and has at most a quarter
//   more risky area;
//   MinAfterCuts: minimum risky area after cutting, where a piece counts as 0.2 % of the present
//   risky area, then minimum height; no small rotations. With checkedCuts the best by cutOutcome
//   are checked one after another, four at most, until the next one cannot be better. The present
//   orientation is kept if it is at most a quarter worse than the best one;
//   LeastTension: minimum tension across the layers; of those within 5 % of it minimum risky area,
//   then minimum height. The present orientation is kept if it is among these, and has at most a
//   quarter more risky area than the best; no small rotations;
//   MinResidualArea: compares other orientations instead, see minResidualRotation().
// Same result for any number of threads. Preconditions (Error{Internal}): mesh not empty, voxelMm
// > 0, cutOutcome for MinAfterCuts, tension for LeastTension. Throws Error{Usage} as
// voxel::solidVoxels(), and what cutOutcome throws; Cancelled.
Orientation bestOrientation(const geometry::TriangleMesh& mesh, Objective objective,
                            const OrientOptions& options, const base::RunContext& ctx);

} // namespace voluta::placement
