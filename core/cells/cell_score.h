// How much of what a cell may be asked to print it reaches with all bodies clear. Poses: the tip at
// points of a ball that stands on the plate, tilted to all sides, any turn about the nozzle; the
// plate a disc of 40 mm; a ball of three quarters of that radius stands for the part, which links
// must not touch.
#pragma once

#include "base/run_context.h"
#include "process/process.h"
#include "robot/cell.h"

#include <vector>

namespace voluta::cells {

inline constexpr double kClearMm = 3.0; // what counts as clear: a plan keeps 2

struct PosePattern {
  double radiusMm = 65.0; // of the ball
  int shells = 9;         // points on the ball's surface, as many again at half its radius
  int sides = 8;          // of each tilt but the first
  int turns = 16;         // about the nozzle
  std::vector<double> tiltDeg = {0, 30, 60, 90, 120}; // an arm that cannot tilt: the first alone
};

struct CellScore {
  std::vector<int> poses, reached, clear; // of each tilt
  double share(std::size_t tilt) const;   // that is clear, 0..1
  double share() const;                   // of all poses
  double meanOfTilts() const;
  CellScore& operator+=(const CellScore& other);
};

CellScore scoreOf(const robot::Cell& cell, const process::Process& process,
                  const PosePattern& pattern, const base::RunContext& ctx);

// The corners of the disc of 40 mm that stands for the plate.
std::vector<Eigen::Vector2d> smallPlate();

} // namespace voluta::cells
