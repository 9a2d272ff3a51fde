// What timesOf() (timing.h) takes, of runs and of the ways between them.
#pragma once

#include "motion/run.h"
#include "motion/timing.h"
#include "motion/transfers/transfer.h"
#include "robot/cell.h"

#include <vector>

namespace voluta::process {
struct Process;
}

namespace voluta::motion {

TimingLimits timingLimits(const robot::Cell& cell, const process::Process& process);

// The joints of a run's points, external axes where they would be without steps.
std::vector<robot::JointVector> jointsOf(const std::vector<RunPoint>& points);

// Of a run's points, which are printed without a stop.
std::vector<TimedPoint> timedPoints(const robot::Cell& cell, const std::vector<RunPoint>& points);
// Of a way that begins at `from`: one more than it has points.
std::vector<TimedPoint> timedPoints(const RobotState& from, const Transfer& transfer,
                                    double speedMmPerS);

} // namespace voluta::motion
