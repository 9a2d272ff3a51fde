// Search for the position of a stationary nozzle, for an arm that holds the plate under it
// (RoboFDM, Wu et al. 2017, II.A): the position where the part's box contains most of the frames
// the arm can bring its plate to.
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
  double stepMm = 25.0;                                    // between tried positions, > 0
  Eigen::Vector3i boxSteps = Eigen::Vector3i::Constant(8); // of the part's box, even, >= 2
  std::size_t samples = 200000;                            // of joints, uniform within their limits
  std::uint64_t seed = 1;
};

// Returns the origins of the sampled work frames that do not face down (z of the work frame not
// below the horizon), in the base [mm]. The arm's bodies are ignored.
std::vector<Eigen::Vector3d> reachableFrames(const robot::RobotModel& robot,
                                             const NozzleSearch& search);

// Returns how many of them are in the box of that size around a position, [at - size / 2, at + size
// / 2).
std::size_t framesInBox(const std::vector<Eigen::Vector3d>& frames, const Eigen::Vector3d& at,
                        const Eigen::Vector3d& sizeMm);

struct NozzlePlace {
  Eigen::Vector3d at = Eigen::Vector3d::Zero(); // of the tip, in the base [mm]
  std::size_t frames = 0;                       // in the box around it
};
// Searches exhaustively over the lattice of whole steps: most frames in the box [at - half, at +
// half); among equal ones the lowest, then the nearest in y to 0, then the first in x. If there are
// no frames, returns 0 of them. `steps`: size of the box along x, y, z.
NozzlePlace bestNozzlePlace(const std::vector<Eigen::Vector3d>& frames, double stepMm,
                            const Eigen::Vector3i& boxSteps);

} // namespace voluta::cells
