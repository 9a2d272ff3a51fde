// Collision-free joint ways where simpler ones fail: OMPL's RRT-Connect (Kuffner, LaValle 2000).
#pragma once

#include "robot/robot_model.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

struct TreeOptions {
  int iterations = 4000; // growth steps, then it gives up; never a time
  double rangeRad = 0.5; // longest step of the trees, sliding joints by robot::asTurn
  std::uint64_t seed = 1;
  int shortcuts = 60; // tries to straighten the way found
};

// Joints from `from` to `to` (both included), linear between them, every stretch of which
// `segmentFree` accepts; empty when none was found. Sampling stays within limits and within a
// turn of the straight way. The same for the same seed.
// Throws Cancelled. Preconditions: from and to within limits.
std::vector<robot::JointVector> treeWay(
    const robot::JointVector& from, const robot::JointVector& to,
    const std::vector<robot::JointLimits>& limits,
    const std::function<bool(const robot::JointVector&)>& free,
    const std::function<bool(const robot::JointVector&, const robot::JointVector&)>& segmentFree,
    const TreeOptions& options, const base::RunContext& ctx);

} // namespace voluta::motion
