// Where over its plate, and at which tilt, a cell's nozzle gets: some turn about the nozzle and
// some branch of the arm inside its limits, all bodies of the cell clear of each other, the head's
// true shape among them. What is printed is no body here: the map is of the cell, whatever the
// part.
#pragma once

#include "base/run_context.h"
#include "collision/cell_collision.h"
#include "process/process.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::cells {

// The poses that are tried.
struct ReachGrid {
  double spacingMm = 20.0;       // of points on the plate, one of them at the work frame's origin
  std::vector<double> heightsMm; // of the tip over the plate, ascending, > 0
  std::vector<double> tiltsRad;  // of the build direction from upright, ascending from 0, < pi
  int azimuths = 12;             // to so many sides, the first towards x
  int turns = 16;                // about the nozzle
  int axisPlaces = 8;            // of each external axis, its rest besides (axisPlaces())
};

// Heights from the process's first layer up to `heightMm`, tilts up to 60 degrees; as many points
// across the plate as are seen well: 24 over its longer side, rounded to 5 mm.
// Preconditions: the cell has a plate; heightMm > 0.
ReachGrid usualGrid(const robot::Cell& cell, const process::Process& process, double heightMm);

// Build directions: upright, then each tilt to all sides.
struct Direction {
  std::size_t tilt = 0; // index into tiltsRad
  int azimuth = 0;
  Eigen::Vector3d build; // unit, away from the plate
};
std::vector<Direction> directionsOf(const ReachGrid& grid);

// Where the external axes are tried: all together at rest, then each at `places` values spread
// evenly over its range (a turning one with a turn or more: over one turn from its lower limit or
// -180 degrees, whichever is more), every combination. Without axes one empty entry.
std::vector<robot::JointVector> axisPlaces(const robot::Cell& cell, int places);

// What was reached. Points are (column, row) of a lattice about the work frame's origin; only those
// on the plate count.
class ReachMap {
public:
  // Nothing reached yet. `plate`: convex, counter-clockwise.
  ReachMap(ReachGrid grid, std::vector<Eigen::Vector2d> plate);

  const ReachGrid& grid() const { return grid_; }
  const std::vector<Eigen::Vector2d>& plate() const { return plate_; }
  const std::vector<Direction>& directions() const { return directions_; }
  const std::vector<Eigen::Vector2d>& points() const { return points_; } // on the plate, mm
  // Of points(): its column and row, which neighbours share but for one.
  const std::vector<Eigen::Vector2i>& lattice() const { return lattice_; }

  bool reached(std::size_t point, std::size_t height, std::size_t direction) const {
    return reached_[index(point, height, direction)] != 0;
  }
  void setReached(std::size_t point, std::size_t height, std::size_t direction, bool is) {
    reached_[index(point, height, direction)] = is ? 1 : 0;
  }

  // Share of the poses reached over a point, at heights up to heightMm (the lowest always counts)
  // and tilts up to tiltRad (upright always counts), in [0, 1].
  double share(std::size_t point, double heightMm, double tiltRad) const;
  // Over all points: of those at this tilt alone.
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

// `margins`: how near bodies may come to each other, as for a motion. Preconditions
// (Error{Internal}): as ReachGrid says. Throws Error{Usage} where the cell has no plate (a rod);
// Cancelled. A cell that brings the nozzle to one direction only (Cell::tilts()) is asked for
// upright poses alone: other tilts are left out of the grid. Same result for any number of threads.
ReachMap reachMap(const robot::Cell& cell, const process::Process& process, ReachGrid grid,
                  const collision::Margins& margins, const base::RunContext& ctx);

} // namespace voluta::cells
