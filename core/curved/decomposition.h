// The result of curved mode's decomposition of a part's solid voxels, before layers are extracted.
#pragma once

#include "plan/finding.h"
#include "voxel/voxel_grid.h"

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace voluta::curved {

// Why a voxel is not printed.
enum class Loss : std::uint8_t {
  None = 0,
  Shadowed = 1,  // Inside the front of voxels that had to be printed before
  Unreached = 2, // Not connected to the platform through the part
  Cascade = 3    // Supported only by shadowed voxels
};

// Flat arrays over grid.cellCount() cells.
struct Decomposition {
  voxel::VoxelGrid grid;
  std::vector<std::int32_t> rank; // 0 outside, n >= 1: layer in growth order, -1: missed
  std::vector<Loss> loss;         // None where rank >= 0; empty: not computed
  // Nonzero: deeper than half a voxel inside the flat front, but the head itself reaches it in the
  // direction of frontNormal. 1: clear of all lower ranks; 2: clear of all lower levels of the
  // field. Empty: none.
  std::vector<std::uint8_t> byHead;
  std::vector<std::uint8_t> support; // 1: support material, printed like the part; empty: none
  // Level of a printed voxel's centre [mm] above the platform along the growth: layer L covers [L
  // h, (L + 1) h). NaN elsewhere. Empty if the scheme yields ranks only (plain greedy): then level
  // = (rank - 1/2) * pitch.
  std::vector<float> field;
  // Outward normal of the convex front through the voxel when it is printed: a direction in which a
  // flat head clears everything printed earlier. Zero outside.
  std::vector<Eigen::Vector3f> frontNormal;
  // How deep a voxel's centre may be inside the hull of the platform and all lower ranks: 0, or up
  // to half a voxel if loops cannot close otherwise
  double epsilonMm = 0.0;
  // Convex polygon (counter-clockwise) on which printing starts
  std::vector<Eigen::Vector2d> platform;
  std::string growth; // Growth scheme used
  std::size_t voxels = 0;
  int layers = 0; // Number of distinct ranks
  // missed = shadowed (including the cascade) + unreached
  std::size_t missedVoxels = 0, shadowedVoxels = 0, unreachedVoxels = 0, cascadeVoxels = 0;
  std::size_t headVoxels = 0;    // Printed voxels with byHead set
  std::size_t supportVoxels = 0; // Printed as support, not counted in `voxels`
  plan::Findings findings;       // Groups of missed voxels: place, number, reason, remedy
  struct {
    double peel = 0, grow = 0, smooth = 0;
  } seconds;
};

} // namespace voluta::curved
