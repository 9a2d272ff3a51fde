// The rest of a motion from a given point on, with the part as printed up to there.
#pragma once

#include "plan/trajectory.h"

#include <cstddef>
#include <optional>

namespace voluta::base {
class RunContext;
}
namespace voluta::collision {
class GrowingPart;
}
namespace voluta::plan {
struct ToolPlan;
}
namespace voluta::process {
class Tooling;
}
namespace voluta::robot {
class Cell;
}

namespace voluta::motion {

struct MotionOptions;

// Returns the point at which printing can resume at or after `point`: a point that is a waypoint
// and from which a Print move leads on; within a bead the last waypoint before `point`. Returns
// nullopt if nothing is printed from there on.
std::optional<std::size_t> resumePoint(const plan::Trajectory& trajectory, std::size_t point);
// Returns the start of the path's first printed bead. Returns nullopt if neither the path nor any
// later one is printed.
std::optional<std::size_t> resumePointOfPath(const plan::Trajectory& trajectory,
                                             const plan::ToolPlan& plan, std::size_t path);

// Returns the start of the bead being printed on the way to `point`, or of the next one: as
// resumePointOfPath. Returns nullopt if nothing is printed from there on.
std::optional<std::size_t> resumePointOfBead(const plan::Trajectory& trajectory, std::size_t point);

// Returns the first waypoint that is not printed before `point`: those below it are.
std::size_t printedBefore(const plan::Trajectory& trajectory, std::size_t point);

// Returns points [first, last) as a separate motion: times and material from 0, the first point
// reached by a Joint move from rest, and the events between them and at the motion's end.
// Precondition (Error{Internal}): first < last <= pointCount.
plan::Trajectory partOf(const plan::Trajectory& trajectory, std::size_t first, std::size_t last);

struct Resumed {
  // The motion up to the point, then home along the reversed approach, then the rest: from home,
  // approach, and all remaining motions as planned. The rest begins with the tool of its first bead
  // (plan::Trajectory::toolAt(firstPoint)). In a job of several tools, and with purge.primesBeside
  // where a prime at home would drop onto the part, the arm first goes to a place beside the part,
  // where the nozzle is purged (change_place.h). If the rest begins with a bead, the pauses, waits
  // and outputs before that bead come again before the first move from home; a wait there is
  // followed by a prime.
  plan::Trajectory trajectory;
  std::size_t firstPoint = 0; // Start of the rest: home
};

// Resumes `trajectory` at `point` (resumePoint). The approach is planned clear of the cell and of
// the part printed so far. The rest keeps its joints and its times, except that the interrupted run
// starts from rest. `resumedAt`: where the trajectory was taken up before; 0: never. Returns
// nullopt if no transfer from home is found. Preconditions: `part` was grown from `plan`, the
// trajectory moves along it, and is the cell's. Throws Cancelled.
std::optional<Resumed> resumeAt(const plan::Trajectory& trajectory, std::size_t point,
                                const plan::ToolPlan& plan, const robot::Cell& cell,
                                const process::Tooling& tooling, const collision::GrowingPart& part,
                                const MotionOptions& options, std::size_t resumedAt,
                                const base::RunContext& ctx);

} // namespace voluta::motion
