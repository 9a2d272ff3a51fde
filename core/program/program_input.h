// Input of the program writers.
#pragma once

#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "process/tooling.h"
#include "program/program_options.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace voluta::program {

// The motion to `point` is a circular arc of the nozzle's tip on the part that passes `tipMm` (work
// frame). If the arm holds the part, its orientation is constant, so that each TCP moves on an arc.
struct ArcVia {
  std::size_t point = 0;
  Eigen::Vector3d tipMm = Eigen::Vector3d::Zero();
};

// References: the caller keeps them alive while a writer runs. Preconditions (Error{Internal}):
// trajectory.dof == cell.dof(), its arrays have equal lengths, there is at least one point, and its
// waypoints are indices into `toolPlan` or kNoWaypoint.
struct ProgramInput {
  const plan::ToolPlan& toolPlan;
  const plan::Trajectory& trajectory;
  const robot::Cell& cell;
  process::Tooling tooling;
  std::string name; // of the part; file and function names are derived from it
  ProgramOptions options = {};
  // Hash of the motion before its points were merged for this dialect (job_head.h); empty: hash of
  // `trajectory`.
  std::string job = {};
  std::span<const ArcVia> arcs = {}; // ascending by point; empty unless the dialect has arcs
  bool foreign = false;              // for a controller other than the cell's; set by writeProgram
  // The verdict of the replay, a line of the head (job_head.h, kVerdictMark); empty: none.
  std::string_view verdict = {};

  // Of the tool that the program begins with.
  const process::Process& process() const { return tooling.at(trajectory.firstTool).process; }
  // Whether the program selects its tool before its first motion: an earlier run may have left
  // another one.
  bool selectsTool() const { return !tooling.isOne(); }
};

} // namespace voluta::program
