// Lowers the greatest jerks of a run window by window (Dai 2020, algorithm 6).
#pragma once

#include "motion/bead_run.h"
#include "motion/smoothing/smooth_run.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// As published
struct LocalFilter {
  std::size_t window = 5, wider = 5, widest = 20; // points on both sides of a place
  int rounds = 100;
};

// Returns the run with other rotations about the nozzle around the places whose jerk over the
// finished times exceeds maxJerk [rad/s3] (sliding joints by robot::asAngle), the greatest first.
// Each window is smoothed to the minimum sum of squared jerks (RotationSmoother) with all other
// points held; if that sum does not fall or the window would collide or leave its path, it becomes
// wider, and its points are locked at last. Both ends of the run and all directions stay. The jerk
// may exceed maxJerk in the end. Precondition: `points` are collision-free. The result does not
// depend on the number of threads. Throws Cancelled.
std::vector<RunPoint> filteredRun(const RunSmoothing& by, std::vector<RunPoint> points,
                                  const Meets& meets, double maxJerk, const LocalFilter& options,
                                  const base::RunContext& ctx);

} // namespace voluta::motion
