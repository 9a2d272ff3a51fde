// Beads laid on a grid, by volume.
//
// Model: material of a piece of bead first takes the stadium section (Castelli 2.1.1) that hangs
// below the nozzle's tip against the build direction: height h, and the width that its volume per
// length gives. Pieces that go on in one another end at a common miter, so that bends leave no
// wedges open; from 60 degrees on each ends square. What earlier beads leave no room for is
// displaced, in proportion to the room,
//   1. within the w x h rectangle round the section (the gaps at the round ends: it is this flow
//      that makes beads at a distance of w - (1 - pi/4) h tile without gaps),
//   2. then within a rectangle wider by a quarter of w to either side,
// both along the piece. What finds no room there is excess. A cell takes 1 at most, so
// laid = sum of fill x cell volume + excess, always.
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

// A straight, short piece of a bead (at most about a millimetre). Work frame, mm.
struct BeadPiece {
  Eigen::Vector3d from, to;                   // tip
  Eigen::Vector3d fromDirection, toDirection; // unit, from the bead into the nozzle
  float fromHeightMm = 0, toHeightMm = 0;     // > 0
  float volumeMm3 = 0;                        // >= 0
  float runMm = 0;                            // length of the bead laid without a stop, up to `to`
  std::uint32_t run = 0;                      // which bead
  std::uint32_t motion = 0;                   // of the program
  bool ofPart = true;                         // false: support, skirt or prime
  bool waste = false;                         // skirt or prime
};

// The section of a piece: width from its volume and length, and where that is less than its
// height, the circle of the same area. Width is capped at `widthMaxMm`.
struct BeadSection {
  double widthMm, heightMm;
};
BeadSection sectionOf(const BeadPiece& piece, double widthMaxMm);

struct BeadGrid {
  voxel::VoxelGrid grid;
  base::ZeroedArray<float> fill;      // 0..1, all material
  base::ZeroedArray<float> otherFill; // of that, supports and skirts; empty when there are none
  base::ZeroedArray<std::uint32_t> filler; // 1 + piece that filled it more than half; 0: none did
  // That piece, or kNeverFilled.
  std::uint32_t filledBy(std::size_t cell) const { return filler[cell] - 1u; }
  double laidMm3 = 0.0;              // volume of all pieces
  double excessMm3 = 0.0;            // of it, what found no room
  std::vector<float> pieceExcessMm3; // per piece
};

struct DepositOptions {
  double widthMaxMm = 6.0; // no wider bead is believed; more volume becomes excess
  int samplesPerCell = 5;  // lines along the bead, across and down; fewer leave cells unevenly
                           // filled, which shows as gaps and excess that are not there
};

// Pieces in print order. Material outside the grid counts as excess. The same result for any
// number of threads. Throws Cancelled.
BeadGrid depositBeads(const voxel::VoxelGrid& grid, const std::vector<BeadPiece>& pieces,
                      const DepositOptions& options, const base::RunContext& ctx);

// Cubic cells over [low, high]; the pitch grows where more than `maxCells` would be needed.
voxel::VoxelGrid gridOver(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double pitchMm,
                          std::size_t maxCells);

} // namespace voluta::replay
