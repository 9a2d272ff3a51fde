// The few useful orientations of a part on the plate, to choose from.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "placement/orientation_score.h"
#include "placement/printing_time.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::placement {

struct StandingOrientation {
  // Relative to the mesh's present orientation
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  OrientationScore score; // contact within the first layer
  // Voxels that one pass of reverse growth misses, on the hull of the voxels on the plate; the
  // voxel size is the same for all orientations of a part.
  double voxelMm = 0.0;
  std::size_t voxels = 0, missed = 0;
  StandingPart part; // for estimatedSeconds()
  bool now = false;  // the mesh's present orientation

  double missedShare() const; // share of its voxels
};

struct WaysOptions {
  double layerHeightMm = 0.8;              // the contact depth
  double overhangRad = 0.7853981633974483; // facets beyond it are risky
  bool quarterTurns = false;               // true: quarter turns only
  std::size_t voxels = 8000; // approximate size of the grid; voxels are at least a layer high
  std::size_t maxCount = 4;  // number of orientations
};

// Returns the best orientations of the mesh (mm), at most options.maxCount, best first: fewest
// missed voxels (in steps of plan::kBlockingShare), then minimum risky area per contact, then
// minimum height. Considers the present one and the resting places of its hull on which it balances
// with at least an eighth of the largest contact. Only orientations in which the part stands count
// (kMinContact): if it stands at present, that orientation is always included, else never.
// Orientations are distinct: they differ by more than a rotation about the vertical, by more than
// 15 degrees (except from the present one), and in contact, height, overhang or centroid height,
// unlike those of a symmetric part; of equal ones the nearest to the present one is taken. The
// figures do not depend on the mesh's present orientation, except for rounding. Same result for any
// number of threads. Preconditions (Error{Internal}): mesh not empty, maxCount >= 1. Throws
// Error{Usage} as voxel::solidVoxels(); Cancelled.
std::vector<StandingOrientation> waysToStand(const geometry::TriangleMesh& mesh,
                                             const WaysOptions& options,
                                             const base::RunContext& ctx);

// Returns whether the present orientation is poor compared with another: the part does not stand;
// or it misses twice as many voxels, and by a larger share of the part than may be omitted
// (plan::kBlockingShare); or its contact is poor while the other misses no more: a quarter of the
// other's contact without less overhang, or more overhang than contact, and four times as much per
// mm² of contact.
bool liesBadly(const StandingOrientation& now, const StandingOrientation& better);

struct BetterOrientation {
  StandingOrientation now, best;
};
// Returns the present orientation and the first of waysToStand() if the present one is poor in
// comparison. Costs one growth if it is not. Preconditions and errors as there.
std::optional<BetterOrientation> betterOrientation(const geometry::TriangleMesh& mesh,
                                                   const WaysOptions& options,
                                                   const base::RunContext& ctx);

} // namespace voluta::placement
