// The events of a trajectory (tool changes, cuts, pauses) against those that the program states.
#pragma once

#include "plan/program.h"
#include "plan/trajectory.h"
#include "replay/alignment.h"
#include "replay/comparison.h"

#include <vector>

namespace voluta::replay {

// Returns a finding, at its line, for each event that the program lacks, states at another motion
// or states with another tool, and for each stop, tool change or cut between the first and the last
// motion that is not planned. Selecting a tool is no tool change if that tool is selected already.
// Before the first motion only the last selection counts: a program begins with tool 0.
// All statements of marks (plan/marks.h) have to be there in their order, each with its own signal
// and value: those that withdraw signals before the first motion and behind the last one, too.
// The pauses at a planned wait may differ from it in all by 2 % or 0.05 s, the volume of a purge or
// a shot by 2 %.
std::vector<TextFinding> compareEvents(const plan::ReadProgram& program,
                                       const plan::Trajectory& trajectory,
                                       const Alignment& alignment);

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
