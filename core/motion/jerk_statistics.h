// Figures and finding of the jerk of a timed motion.
#pragma once

#include "motion/sequence_times.h"
#include "plan/finding.h"
#include "plan/statistics.h"
#include "robot/cell.h"

#include <optional>

namespace voluta::motion {

// Sets the jerk of beads and transfers, with the times of the greatest ones [s] over all pieces in
// their order, and by how much the limit slowed them. Waits do not count.
void setJerk(const TimedSequence& timed, plan::MotionStatistics& statistics);

// Returns a finding at the time of the greatest jerk if it exceeds maxJerk (MotionOptions), in
// beads or in transfers. Returns nullopt if none does, or without a limit.
std::optional<plan::Finding> jerkFinding(const plan::MotionStatistics& statistics,
                                         const robot::Cell& cell, double maxJerk);

} // namespace voluta::motion
