// Where a nozzle that stands still should stand, for an arm that holds the plate under it (RoboFDM,
// Wu et al. 2017, II.A): where the part's box holds most of the frames that the arm gets its plate
// to.
#pragma once

#include "base/run_context.h"
#include "robot/robot_model.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::cells {

struct NozzleSearch {
  Eigen::Isometry3d flange_T_work = Eigen::Isometry3d::Identity();
  double stepMm = 25.0;                                    // between places tried, > 0
  Eigen::Vector3i boxSteps = Eigen::Vector3i::Constant(8); // of the part's box, even, >= 2
  std::size_t samples = 200000;                            // of joints, evenly within their limits
  std::uint64_t seed = 1;
};

// Origins of the work frames of those samples that do not face down (z of the work frame not below
// the horizon), in the base, mm. The arm is taken to be without bodies.
std::vector<Eigen::Vector3d> reachableFrames(const robot::RobotModel& robot,
                                             const NozzleSearch& search);

// Of them, how many lie in the box of that size about a place, [at - size / 2, at + size / 2).
std::size_t framesInBox(const std::vector<Eigen::Vector3d>& frames, const Eigen::Vector3d& at,
                        const Eigen::Vector3d& sizeMm);

struct NozzlePlace {
  Eigen::Vector3d at = Eigen::Vector3d::Zero(); // of the tip, in the base, mm
  std::size_t frames = 0;                       // in the box about it
};
// Exhaustively over the lattice of whole steps: most frames in the box [at - half, at + half), of
// equals the one lowest, then nearest in y to 0, then first in x. No place where there are no
// frames: 0 of them. `steps`: of the box along x, y, z.
NozzlePlace bestNozzlePlace(const std::vector<Eigen::Vector3d>& frames, double stepMm,
                            const Eigen::Vector3i& boxSteps);

} // namespace voluta::cells
