// What curved mode decides about a part's solid voxels, before layers are cut from it.
#pragma once

#include "plan/finding.h"
#include "voxel/voxel_grid.h"

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace voluta::curved {

// Why a voxel is not laid.
enum class Loss : std::uint8_t {
  None = 0,
  Shadowed = 1,  // inside the front of what had to be laid before it
  Unreached = 2, // no way through the part from the platform
  Cascade = 3    // hangs on shadowed voxels only
};

// Flat arrays over grid.cellCount() cells.
struct Decomposition {
  voxel::VoxelGrid grid;
  std::vector<std::int32_t> rank; // 0 outside, n >= 1 its layer in growth order, -1 missed
  std::vector<Loss> loss;         // None where rank >= 0; empty: not told
  // Not 0: deeper than half a voxel inside the flat front, but the head itself reaches it in the
  // direction of frontNormal. 1: past all of lower rank; 2: past all of lower levels of the field.
  // Empty: none.
  std::vector<std::uint8_t> byHead;
  std::vector<std::uint8_t> support; // 1: support material, laid like the part; empty: none
  std::vector<float> field; // level of a printed voxel's centre, mm above the platform along
                            // the growth: layer L covers [L h, (L + 1) h). NaN elsewhere.
                            // Empty where the scheme gives ranks only (plain greedy): then
                            // level = (rank - 1/2) * pitch.
  std::vector<Eigen::Vector3f> frontNormal; // outward normal of the convex front through the voxel
                                            // when it is laid: a direction in which a flat head
                                            // clears all that is earlier. Zero outside.
  double epsilonMm = 0.0; // how deep inside the hull of the platform and all lower ranks a voxel's
                          // centre may lie: 0, or half a voxel where loops close only so
  std::vector<Eigen::Vector2d> platform; // convex polygon (counter-clockwise) material starts on
  std::string growth;                    // scheme that made it
  std::size_t voxels = 0;
  int layers = 0; // distinct ranks
  // missed = shadowed (the cascade among them) + unreached
  std::size_t missedVoxels = 0, shadowedVoxels = 0, unreachedVoxels = 0, cascadeVoxels = 0;
  std::size_t headVoxels = 0;    // laid, of byHead
  std::size_t supportVoxels = 0; // laid as support, not among `voxels`
  plan::Findings findings;       // groups of missed voxels: where, how many, why, what would help
  struct {
    double peel = 0, grow = 0, smooth = 0;
  } seconds;
};

} // namespace voluta::curved
