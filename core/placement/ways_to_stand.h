// The few ways in which a part can stand on the plate, to choose from.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "placement/orientation_score.h"
#include "process/process.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::placement {

struct Way {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity(); // from how the mesh lies
  OrientationScore score;                                   // contact within the first layer
  // What one pass of reverse growth misses, over the hull of what touches the plate, on voxels
  // that are the same size for all ways of a part.
  double voxelMm = 0.0;
  std::size_t voxels = 0, missed = 0;
  double seconds = 0.0; // estimatedSeconds()
  bool now = false;     // as the mesh lies

  double missedShare() const; // of its voxels
};

struct WaysOptions {
  process::Process process;                // its layer height is the contact's depth
  double overhangRad = 0.7853981633974483; // beyond which a facet is risky
  bool quarterTurns = false;               // only those
  std::size_t voxels = 8000;               // of the grid, about; none narrower than a layer is high
  std::size_t most = 4;                    // ways
};

// The time that a way takes, roughly: the volume by what flows from the nozzle at the process's
// bead and speed, and for each layer's height up to the part's a prime, a travel across the part's
// footprint (its diagonal) and the ramps of that travel. Supports, reach and slow places are not in
// it: it compares ways of one part, and is no promise. volumeMm3, heightMm, acrossMm >= 0.
double estimatedSeconds(double volumeMm3, double heightMm, double acrossMm,
                        const process::Process& process);

// The best ways for the mesh (mm) to stand, at most options.most, the best first: fewest missed
// voxels (steps of plan::kBlockingShare), then least risky area for the contact, then least height.
// Tried are how it lies and the resting places of its hull, those on which it balances with an
// eighth of the largest contact or more. Only what stands counts (kLeastContact): a part that lies
// on a tip is not among its own ways, one that stands always is.
// Ways are distinct: not turned about the vertical only, not within 15 degrees of each other (but
// for how it lies), nor of the same contact, height, overhang and height of the middle, as those of
// a symmetric part are; of those the nearest to how it lies is taken. Figures do not depend on how
// the mesh lies but for what rounding does. Same result for any number of threads.
// Preconditions (Error{Internal}): mesh not empty, most >= 1. Throws Error{Usage} as
// voxel::solidVoxels(); Cancelled.
std::vector<Way> waysToStand(const geometry::TriangleMesh& mesh, const WaysOptions& options,
                             const base::RunContext& ctx);

// Does a part lie badly, and would do better in that other way? It does not stand; or it misses
// twice what the other misses, and by more of the part than may be left out (plan::kBlockingShare).
// Or its foot is poor beside the other's, which misses no more than that: a quarter of the contact
// without less overhang; or more overhang than contact, and four times as much for each mm2 of it.
bool liesBadly(const Way& now, const Way& better);

struct BetterWay {
  Way now, best;
};
// The first of waysToStand() where the mesh lies badly beside it. Costs one growth where it does
// not. Preconditions and errors as there.
std::optional<BetterWay> betterWay(const geometry::TriangleMesh& mesh, const WaysOptions& options,
                                   const base::RunContext& ctx);

} // namespace voluta::placement
