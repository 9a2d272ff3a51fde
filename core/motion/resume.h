// The rest of a motion, from a place in it on, with the part as it stands then.
#pragma once

#include "collision/growing_part.h"
#include "motion/motion_options.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "process/process.h"
#include "robot/cell.h"

#include <cstddef>
#include <optional>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// Where printing can be taken up at `point` or, where nothing is laid right behind it, next: a
// point that is a waypoint and from which a Print move leads on; within a bead the waypoint before
// `point`. None: nothing is printed from there on.
std::optional<std::size_t> resumePoint(const plan::Trajectory& trajectory, std::size_t point);
// Where the path's first bead that is printed begins. None: it is not printed, nor is any after it.
std::optional<std::size_t> resumePointOfPath(const plan::Trajectory& trajectory,
                                             const plan::ToolPlan& plan, std::size_t path);

// Where the bead begins that is being printed on the way to `point`, or the next one: at its
// beginning, as of resumePointOfPath. None: nothing is printed from there on.
std::optional<std::size_t> resumePointOfBead(const plan::Trajectory& trajectory, std::size_t point);

// Points [first, last) as a motion of its own: times and material from 0, the first one reached by
// a Joint move from rest. Precondition (Error{Internal}): first < last <= pointCount.
plan::Trajectory partOf(const plan::Trajectory& trajectory, std::size_t first, std::size_t last);

struct Resumed {
  // The motion up to the place, from there home along the way on which the rest comes, and the
  // rest: from home, approach, and all that is left as it was planned.
  plan::Trajectory trajectory;
  std::size_t firstPoint = 0; // of the rest: home
};

// Takes `trajectory` up at `point` (resumePoint). The approach is planned clear of the cell and of
// what is laid by then; the rest keeps its joints, and its times but for the run that is cut, which
// begins from rest. None: no way leads there from home. Preconditions: `part` was grown from
// `plan`, the trajectory moves along it, and is the cell's. Throws Cancelled.
std::optional<Resumed> resumeAt(const plan::Trajectory& trajectory, std::size_t point,
                                const plan::ToolPlan& plan, const robot::Cell& cell,
                                const process::Process& process, const collision::GrowingPart& part,
                                const MotionOptions& options, const base::RunContext& ctx);

} // namespace voluta::motion
