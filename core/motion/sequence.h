// Runs in order with the transfers between them: from home to the first run, between runs, and home
// again.
#pragma once

#include "motion/bead_run.h"
#include "motion/ladder/path_planner.h"
#include "motion/motion_scene.h"
#include "motion/refusal.h"
#include "motion/transfers/known_transfers.h"
#include "motion/transfers/transfer.h"

#include <cstddef>
#include <set>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

struct Sequence {
  std::vector<Run> runs;
  std::vector<Transfer> ways; // To runs[i]; one more: home again
};

// Waypoints of one run that no transfer reaches or leaves.
struct SkippedPiece {
  std::vector<std::size_t> waypoints; // Ascending
  bool caught = false;                // No transfer leads away from their end
};

struct ConnectedRuns {
  Sequence sequence;
  std::vector<SkippedPiece> skipped;
  std::vector<Refused> refused;   // Of runs that were planned again
  std::size_t waitsAbovePart = 0; // Pauses and waits for which no place beside the part is reached
};

// Returns bounding spheres of the material printed before each path; one more: of all of it.
std::vector<PrintedBounds> printedBoundsOf(const plan::ToolPlan& plan);

// Returns the robot state with these joints.
RobotState stateAt(const robot::Cell& cell, const robot::JointVector& q);

// Finds the transfers. Between runs of different tools the arm goes home and to a place beside the
// part (change_place.h), where the tool is changed and purged, and wipes its nozzle there. With
// purge.primesBeside it also goes there first if the nozzle has to be primed at rest, and would
// drop onto the part at home. For options.layerEvents that take time it goes there, waits and
// primes the nozzle, before a change of the tool if there is one; a pause without a text of its own
// is left out where the operator changes the tool. Other events come behind the lift from the bead
// before. If no transfer leads from a run to the next, the arm
// goes via home too. If that fails too, the run is planned again from home in another branch of the
// arm, and later runs are planned again from its end.
//
// A transfer to the next run begins with a wipe if options.wipeMm is positive and the wipe is
// collision-free. If the arm cannot leave a run's end, the run is shortened to a point that it can
// leave; if it cannot reach a run's start, the run begins at the first point that it can reach. So
// at worst the whole run is lost, but never later ones. The last transfer, home, always exists if
// there is a run. Throws Cancelled; Error{UnusableInput} if the arm does not reach the dock of a
// tool or the cell's own place for purges. `known`: transfers of this scene; new ones are added.
// `highBefore`: first waypoints of runs, ascending, to which the transfer lifts by kHighLiftMm if
// it can.
ConnectedRuns connectRuns(const MotionScene& scene, std::vector<Run> runs, const RobotState& home,
                          PathPlanner& paths, KnownTransfers& known, const base::RunContext& ctx,
                          const std::set<std::size_t>& highBefore = {});

} // namespace voluta::motion
