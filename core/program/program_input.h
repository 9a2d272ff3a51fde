// What a program is written from.
#pragma once

#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "process/process.h"
#include "program/program_options.h"
#include "robot/cell.h"

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
  ProgramOptions options = {};
  // Hash of the motion before points of it were joined for this dialect (job_head.h); empty: of
  // `trajectory`.
  std::string job = {};
  bool foreign = false; // for a controller that is not the cell's own; writeProgram says so
};

} // namespace voluta::program
