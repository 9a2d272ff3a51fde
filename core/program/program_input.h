// What a program is written from.
#pragma once

#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "process/process.h"
#include "robot/cell.h"

#include <cstddef>
#include <string>

namespace voluta::program {

// References: the caller keeps them alive while a writer runs.
// Preconditions (Error{Internal}): trajectory.dof == cell.dof(), its arrays have one length, at
// least one point; its waypoints are indices into `toolPlan` or kNoWaypoint.
struct ProgramInput {
  const plan::ToolPlan& toolPlan;
  const plan::Trajectory& trajectory;
  const robot::Cell& cell;
  const process::Process& process;
  std::string name; // of the part; file and function names are made from it
  // A program of more motions is cut into files to be run one after the other, each cut where the
  // extruder is off if there is such a place (URScript, RAPID; the other formats are streamed and
  // stay one file). 0: as the dialect has it.
  std::size_t maxMotionsPerFile = 0;
  bool foreign = false; // for a controller that is not the cell's own; writeProgram says so
};

} // namespace voluta::program
