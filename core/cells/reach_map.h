// Map of the positions over the plate, and the tilts, that a cell's nozzle reaches: with some turn
// about the nozzle and some IK branch of the arm within its limits, without collisions between any
// bodies of the cell, including the true shape of the head. Printed material is not considered: the
// map depends on the cell, not on the part.
#pragma once

#include "base/run_context.h"
#include "collision/margins.h"
#include "process/process.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::cells {

// The poses to try.
struct ReachGrid {
  double spacingMm = 20.0;       // of points on the plate, one of them at the work frame's origin
  std::vector<double> heightsMm; // of the tip above the plate, ascending, > 0
  std::vector<double> tiltsRad;  // of the build direction from upright, ascending from 0, < pi
  int azimuths = 12;             // number of tilt directions, the first towards x
  int turns = 16;                // about the nozzle
  int axisPlaces = 8; // per external axis, in addition to its home position (axisPlaces())
};

// Returns a grid with heights from the process's first layer up to `heightMm`, tilts up to 60
// degrees, and a resolution suited for display: 24 points over the plate's longer side, with the
// spacing rounded to 5 mm. Preconditions: the cell has a plate; heightMm > 0.
ReachGrid usualGrid(const robot::Cell& cell, const process::Process& process, double heightMm);

// Build directions: upright, then each tilt to all sides.
struct Direction {
  std::size_t tilt = 0; // index into tiltsRad
  int azimuth = 0;
  Eigen::Vector3d build; // unit, away from the plate
};
std::vector<Direction> directionsOf(const ReachGrid& grid);

// Returns the positions of the external axes to try: all at home, then all combinations of `places`
// values per axis spread evenly over its range (for a rotary axis with a range of a turn or more:
// over one turn from its lower limit or -180 degrees, whichever is larger). Without axes, returns
// one empty entry.
std::vector<robot::JointVector> axisPlaces(const robot::Cell& cell, int places);

// The reached poses. Points are (column, row) of a lattice around the work frame's origin; only
// those on the plate count.
class ReachMap {
public:
  // Creates a map with nothing reached. `plate`: convex, counter-clockwise.
  ReachMap(ReachGrid grid, std::vector<Eigen::Vector2d> plate);

  const ReachGrid& grid() const { return grid_; }
  const std::vector<Eigen::Vector2d>& plate() const { return plate_; }
  const std::vector<Direction>& directions() const { return directions_; }
  const std::vector<Eigen::Vector2d>& points() const { return points_; } // on the plate [mm]
  // Column and row of each of points(); they differ by 1 in one of both between neighbours.
  const std::vector<Eigen::Vector2i>& lattice() const { return lattice_; }

  bool reached(std::size_t point, std::size_t height, std::size_t direction) const {
    return reached_[index(point, height, direction)] != 0;
  }
  void setReached(std::size_t point, std::size_t height, std::size_t direction, bool is) {
    reached_[index(point, height, direction)] = is ? 1 : 0;
  }

  // Returns the share of poses reached above a point, at heights up to heightMm (the lowest always
  // counts) and tilts up to tiltRad (upright always counts), in [0, 1].
  double share(std::size_t point, double heightMm, double tiltRad) const;
  // Returns the share over all points for this tilt alone.
  double shareOfTilt(std::size_t tilt) const;

private:
  std::size_t index(std::size_t point, std::size_t height, std::size_t direction) const {
    return (point * grid_.heightsMm.size() + height) * directions_.size() + direction;
  }
  ReachGrid grid_;
  std::vector<Eigen::Vector2d> plate_, points_;
  std::vector<Eigen::Vector2i> lattice_;
  std::vector<Direction> directions_;
  std::vector<std::uint8_t> reached_;
};

// `margins`: minimum distances of bodies, as for a motion. Preconditions (Error{Internal}): see
// ReachGrid. Throws Error{Usage} if the cell has no plate (a rod), and Cancelled. For a cell with
// only one nozzle direction (Cell::tilts()), tilts other than upright are removed from the grid.
// The result does not depend on the number of threads.
ReachMap reachMap(const robot::Cell& cell, const process::Process& process, ReachGrid grid,
                  const collision::Margins& margins, const base::RunContext& ctx);

} // namespace voluta::cells
