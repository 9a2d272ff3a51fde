// Shots into pockets in a trajectory.
#pragma once

#include "motion/bead_run.h"
#include "motion/motion_options.h"
#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "process/process.h"

#include <cstddef>
#include <optional>

namespace voluta::motion {

// Returns the index of the run's point from which a shot flows; nullopt if there is none, or the
// arm does not come out of the pocket again.
std::optional<std::size_t> shotPoint(const plan::ToolPlan& plan, const Run& run);

// Adds the shot, and the wait after it, after the trajectory's last point. Returns their duration
// [s].
double addShotEvents(plan::Trajectory& trajectory, double volumeMm3,
                     const process::Process& process, const MotionOptions& options);

// Longest stay of the nozzle in a pocket that leaves the layers around it as they are (Castelli
// 6.3) [s].
inline constexpr double kLongestShotS = 4.0;

// Returns the finding "longShot" about shots that last longer, with the waits after them, at the
// longest; nullopt if there is none.
std::optional<plan::Finding> longShots(const plan::Trajectory& trajectory,
                                       const plan::ToolPlan& plan);

} // namespace voluta::motion
