// Runs in order, with the ways between them: from home to the first one, on from each, home again.
#pragma once

#include "motion/ladder/path_planner.h"
#include "motion/motion_scene.h"
#include "motion/refusal.h"
#include "motion/run.h"
#include "motion/transfers/known_transfers.h"
#include "motion/transfers/transfer.h"

#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

struct Sequence {
  std::vector<Run> runs;
  std::vector<Transfer> ways; // to runs[i]; one more: home again
};

// Waypoints of one run that no way leads to, or none away from.
struct SkippedPiece {
  std::vector<std::size_t> waypoints; // ascending
  bool caught = false;                // the arm would not get away from where they end
};

struct ConnectedRuns {
  Sequence sequence;
  std::vector<SkippedPiece> skipped;
  std::vector<Refused> refused; // where runs were planned again
};

// Balls around what is printed before each path; one more: around everything.
std::vector<PrintedBounds> printedBoundsOf(const plan::ToolPlan& plan);

// The state that the joints are.
RobotState stateAt(const robot::Cell& cell, const robot::JointVector& q);

// Finds the ways. Where none leads from a run to the next, the arm goes home and comes from there;
// where that fails too, the run is planned again as it is come to from home, in another branch of
// the arm, and those that follow it are planned again to follow on it.
// A way to the next run begins with a wipe where options.wipeMm asks for one and it is free.
// Where it would not get away from a run's end, that run ends where it does; where it cannot come
// to a run's start, that run begins where it can. What is lost so is a piece of that run, at the
// worst all of it, and never what follows. The last way, home, is always there where a run is.
// Throws Cancelled. `known`: of this scene; grows.
ConnectedRuns connectRuns(const MotionScene& scene, std::vector<Run> runs, const RobotState& home,
                          PathPlanner& paths, KnownTransfers& known, const base::RunContext& ctx);

} // namespace voluta::motion
