// Collision-free joint paths where simpler ones fail: OMPL's RRT-Connect (Kuffner, LaValle 2000).
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
  int iterations = 4000; // maximum number of growth steps; there is no time limit
  double rangeRad = 0.5; // longest step of the trees, sliding joints by robot::asAngle
  std::uint64_t seed = 1;
  int shortcuts = 60; // attempts to shorten the path found
};

// Returns joints from `from` to `to` (both included), linear between them, such that `segmentFree`
// accepts every segment; empty if none was found. Sampling stays within the limits and within one
// turn of the straight path. Deterministic for the same seed. Throws Cancelled. Precondition: from
// and to are within the limits.
std::vector<robot::JointVector> treePath(
    const robot::JointVector& from, const robot::JointVector& to,
    const std::vector<robot::JointLimits>& limits,
    const std::function<bool(const robot::JointVector&)>& free,
    const std::function<bool(const robot::JointVector&, const robot::JointVector&)>& segmentFree,
    const TreeOptions& options, const base::RunContext& ctx);

} // namespace voluta::motion
