// The planned nozzle path over time, as a polyline.
#pragma once

#include "plan/trajectory.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::record {

// Vertices in order; the segment that ends at a vertex has the vertex's values. Never empty.
struct PlannedRun {
  std::vector<Eigen::Vector3d> tip; // work frame [mm]
  std::vector<double> alongMm;      // length of the path up to the vertex
  std::vector<double> timeS;        // as plan::Trajectory::timeS
  std::vector<double> extrudedMm3;
  std::vector<char> prints;       // whether the segment is part of a bead
  std::vector<std::size_t> point; // the trajectory's point that the segment leads to

  std::size_t size() const { return tip.size(); }
  double lengthMm() const { return alongMm.back(); }
};

// A place on the polyline, linear between its vertices.
struct PlannedPlace {
  std::size_t segment = 1; // ends at this vertex
  double alongMm = 0.0, timeS = 0.0, extrudedMm3 = 0.0;
};
// Precondition: two vertices or more. Lengths outside the path are moved to its ends.
PlannedPlace placeAt(const PlannedRun& run, double alongMm);

// Returns the path from point `first` on. Joint motions are divided so that the tip moves at most
// 2 mm in a segment. Precondition: trajectory.dof == cell.dof(), and it has points. Throws
// Cancelled.
PlannedRun plannedRun(const plan::Trajectory& trajectory, const robot::Cell& cell,
                      std::size_t first, const base::RunContext& ctx);

} // namespace voluta::record
