// Input of timesOf() (timing.h) for runs and for the transfers between them.
#pragma once

#include "motion/bead_run.h"
#include "motion/timing.h"
#include "motion/transfers/transfer.h"
#include "robot/cell.h"

#include <vector>

namespace voluta::process {
struct Process;
}

namespace voluta::motion {

// Returns the limits of motions with that process.
TimingLimits timingLimits(const robot::Cell& cell, const process::Process& process);

// Returns the joints of a run's points, with external axes as if they had no steps.
std::vector<robot::JointVector> jointsOf(const std::vector<RunPoint>& points);

// Returns the points of a run, which is printed without a stop.
std::vector<TimedPoint> timedPoints(const robot::Cell& cell, const std::vector<RunPoint>& points);
// Returns the points of a transfer that begins at `from`: one more than the transfer has.
std::vector<TimedPoint> timedPoints(const RobotState& from, const Transfer& transfer,
                                    double speedMmPerS);

} // namespace voluta::motion
