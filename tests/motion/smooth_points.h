// Helpers shared by tests of smoothed runs.
#pragma once

#include "base/run_context.h"
#include "motion/bead_run.h"
#include "motion/smoothing/smooth_turns.h"
#include "robot/cell.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace voluta::test {

inline base::RunContext onThreads(int threads) {
  return base::RunContext(base::CancelToken(), threads);
}

inline std::vector<double> evenTimes(std::size_t count, double step) {
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i)
    times.push_back(step * static_cast<double>(i));
  return times;
}

// Of tip (mm) and direction from the point's own.
inline double largestOff(const robot::Cell& cell, const motion::RunPoint& p,
                         const motion::TurnedPoint& at) {
  const Eigen::Isometry3d pose = cell.work_T_tool(at.q);
  return std::max((pose.translation() - p.at.tip).norm(),
                  (-pose.linear().col(2) - p.at.direction()).norm());
}

} // namespace voluta::test
