// The events of a trajectory (tool changes, cuts, pauses) against those that the program states.
#pragma once

#include "plan/program.h"
#include "plan/trajectory.h"
#include "process/tooling.h"
#include "replay/alignment.h"
#include "replay/comparison.h"
#include "robot/cell.h"

#include <cstddef>
#include <vector>

namespace voluta::replay {

// Returns a finding, at its line, for each event that the program lacks, states at another motion,
// states with another tool or out of the planned order (change_order.h), and for each stop, tool
// change or cut between the first and the last motion that is not planned. Selecting a tool is no
// tool change if that tool is selected already. `firstPoint`: point of the trajectory at which the
// program begins; earlier events are not its own. In a job of several tools the program has to
// select the tool of that point before its first motion.
// So is a stop that shows another text, and a line that was asked for before a layer
// (program/own_lines.h) with another text. Events come before the first of the motions that lead
// to their point.
// All statements of marks (plan/marks.h) have to be there in their order, each with its own signal
// and value: those that withdraw signals before the first motion and behind the last one, too.
// The pauses at a planned wait may differ from it in all by 2 % or 0.05 s, the volume of a purge or
// a shot by 2 %.
std::vector<TextFinding> compareEvents(const plan::ReadProgram& program,
                                       const plan::Trajectory& trajectory,
                                       const Alignment& alignment, const process::Tooling& tooling,
                                       const robot::Cell& cell, std::size_t firstPoint = 0);

// Returns a finding for each planned statement of the user's own: nothing judges what it does. Each
// before `firstPoint`, which the program does not run, has another finding, without a line.
std::vector<TextFinding> ownStatements(const plan::ReadProgram& program,
                                       const plan::Trajectory& trajectory,
                                       const Alignment& alignment, std::size_t firstPoint = 0);

// What is planned while the arm is at rest before each motion; empty: nothing.
struct PlannedStops {
  std::vector<double> seconds;  // of waits and purges
  std::vector<double> purgeMm3; // volume that flows out
  std::vector<char> shot;       // whether it flows into a pocket

  double secondsAt(std::size_t motion) const {
    return motion < seconds.size() ? seconds[motion] : 0.0;
  }
  bool shotAt(std::size_t motion) const { return motion < shot.size() && shot[motion] != 0; }
  double purgeAt(std::size_t motion) const {
    return motion < purgeMm3.size() ? purgeMm3[motion] : 0.0;
  }
};
PlannedStops plannedStops(const plan::ReadProgram& program, const plan::Trajectory& trajectory,
                          const Alignment& alignment);

} // namespace voluta::replay
