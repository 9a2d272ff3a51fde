// Score of a cell: the share of printing poses it reaches without collisions. Poses: the tip at
// points of a ball on the plate, tilted to all sides, with any turn about the nozzle. The plate is
// a disc of 40 mm; a ball of three quarters of the radius represents the part, which links must not
// touch.
#pragma once

#include "base/run_context.h"
#include "process/process.h"
#include "robot/cell.h"

#include <vector>

namespace voluta::cells {

inline constexpr double kClearMm = 3.0; // minimum clearance; plans keep 2 mm

struct PosePattern {
  double radiusMm = 65.0; // of the ball
  int shells = 9;         // points on the ball's surface, and as many at half its radius
  int sides = 8;          // per tilt except the first
  int turns = 16;         // about the nozzle
  std::vector<double> tiltDeg = {0, 30, 60, 90, 120}; // for an arm that cannot tilt, only the first
};

struct CellScore {
  std::vector<int> poses, reached, clear; // per tilt
  double share(std::size_t tilt) const;   // of collision-free poses, 0..1
  double share() const;                   // over all poses
  double meanOfTilts() const;
  CellScore& operator+=(const CellScore& other);
};

CellScore scoreOf(const robot::Cell& cell, const process::Process& process,
                  const PosePattern& pattern, const base::RunContext& ctx);

// Returns the corners of the disc of 40 mm that represents the plate.
std::vector<Eigen::Vector2d> smallPlate();

} // namespace voluta::cells
