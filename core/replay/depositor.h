// Deposition of beads on a grid, by volume.
//
// Model: the material of a piece of bead first takes the stadium section (Castelli 2.1.1) below the
// nozzle's tip, against the build direction: its height is h, and its width follows from the volume
// per length. Consecutive pieces of a bead end at a common miter, so that bends leave no wedges
// open; from 60 degrees on each ends square. Material that earlier beads leave no room for is
// displaced, in proportion to the free room,
//   1. within the w x h rectangle around the section (the gaps at the round ends: this flow makes
//   beads at a distance of w - (1 - pi/4) h fill the layer without gaps),
//   2. then within a rectangle wider by a quarter of w on either side,
//
// Both extend along the piece. The rest is excess. A cell holds at most 1, so that laid = sum of
// fill x cell volume + excess, always.
#pragma once

#include "base/zeroed_array.h"
#include "voxel/voxel_grid.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

inline constexpr std::uint32_t kNeverFilled = std::numeric_limits<std::uint32_t>::max();

// A straight, short piece of a bead (at most about 1 mm). Work frame [mm].
struct BeadPiece {
  Eigen::Vector3d from, to;                   // nozzle tip
  Eigen::Vector3d fromDirection, toDirection; // unit vectors from the bead into the nozzle
  float fromHeightMm = 0, toHeightMm = 0;     // > 0
  float volumeMm3 = 0;                        // >= 0
  float runMm = 0;          // length of the bead printed without a stop, up to `to`
  std::uint32_t run = 0;    // index of the bead
  std::uint32_t motion = 0; // index in the program
  bool ofPart = true;       // false: support, skirt or prime
  bool waste = false;       // skirt or prime
  std::uint8_t item = 0;    // index in the job's items
  // Flows out at `from` into a pocket below it, which is as deep as the height (shot_fill.h). All
  // other pieces without length are excess.
  bool shot = false;
};

// Returns the section of a piece. Its width follows from volume and length; if that is less than
// the height, the section is the circle of the same area. The width is limited to `widthMaxMm`.
struct BeadSection {
  double widthMm, heightMm;
};
BeadSection sectionOf(const BeadPiece& piece, double widthMaxMm);
// Returns an upper limit for the width of a piece, where no process limits it [mm].
double widestOf(const BeadPiece& piece);

struct BeadGrid {
  voxel::VoxelGrid grid;
  base::ZeroedArray<float> fill;      // 0..1, all material
  base::ZeroedArray<float> otherFill; // of that, supports and skirts; empty if there are none
  // Share inside the w x h rectangles around the part's beads, in 255ths; empty: not known
  base::ZeroedArray<std::uint8_t> rectangle;
  // 1 + the piece that filled more than half of the cell; 0: none did
  base::ZeroedArray<std::uint32_t> filler;
  // Returns that piece, or kNeverFilled.
  std::uint32_t filledBy(std::size_t cell) const { return filler[cell] - 1u; }
  double depositedMm3 = 0.0;         // volume of all pieces
  double excessMm3 = 0.0;            // of it, the volume that found no room
  std::vector<float> pieceExcessMm3; // per piece
};

struct DepositOptions {
  double widthMaxMm = 6.0; // upper limit for a bead's width; more volume becomes excess
  // lines along the bead, across and down; fewer fill cells unevenly, which shows as false gaps and
  // excess
  int samplesPerCell = 5;
};

// Deposits the pieces in print order. Material outside the grid counts as excess. The result does
// not depend on the number of threads. Throws Cancelled.
BeadGrid depositBeads(const voxel::VoxelGrid& grid, const std::vector<BeadPiece>& pieces,
                      const DepositOptions& options, const base::RunContext& ctx);

// Returns a grid of cubic cells over [low, high]; the pitch is enlarged if more than `maxCells`
// would be needed.
voxel::VoxelGrid gridOver(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double pitchMm,
                          std::size_t maxCells);

} // namespace voluta::replay
