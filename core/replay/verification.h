// The verdict on a program that was read back from its text (docs/design.md, Replay).
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/finding.h"
#include "plan/program.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "replay/judged_runs.h"
#include "replay/worst_places.h"
#include "robot/cell.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// The program as its reader found it, what it was written from, and what it is to make.
struct ReplayInput {
  plan::ReadProgram program; // let go of once it is compared: there are hundreds of bytes a motion
  const plan::ToolPlan& plan;
  const plan::Trajectory& trajectory;
  const robot::Cell& cell;
  const process::Process& process;
  const geometry::TriangleMesh& part; // placed, without what of it is in the ground: work frame, mm
  const platform::PlatformSolid& platform; // what the first beads are laid on
  std::size_t firstPoint = 0; // of the trajectory, where the text begins: the rest of a print
  // Per point of the trajectory, its number in the one that programs compared with each other have
  // in common; empty: this one is it.
  std::span<const std::size_t> commonPoint = {};
};

// What a program has to keep to (docs/design.md, Replay).
struct ReplayThresholds {
  double coveredMin = 0.97;      // share of the part's volume inside beads
  double unsupportedMax = 0.005; // share of bead length with nothing beneath
  double overfillMax = 0.03;     // bead volume outside the part, by part volume
  double massTolerance = 0.03;   // |massRatio - 1|
  std::size_t collisionsMax = 0;
  std::size_t limitViolationsMax = 0;
  double deviationMaxMm = 0.05; // of the executed nozzle path from the planned one
  double flowErrorMax = 0.01;   // share of the printed length with another section
};

struct ThresholdResult {
  std::string name; // the report's key, e.g. "coveredFraction"
  double value = 0.0, limit = 0.0;
  bool passed = false;
};

// Where in the program's text a finding lies, or a motion is said; line 0: nowhere in particular.
// 1-based.
struct TextPlace {
  std::size_t file = 0, line = 0;
};

// What running a program makes, and what meets on the way.
struct RunFigures {
  double coveredFraction = 0.0;
  double unsupportedFraction = 0.0;
  double halfCarriedFraction = 0.0;  // share of bead length carried on less than half its width
  double longestUnsupportedMm = 0.0; // of a bead, without a break, nothing right beneath it
  double overfillFraction = 0.0;     // outside the part and what found no room, by part volume
  double excessFraction = 0.0;       // of that, what found no room
  std::size_t collisions = 0; // contacts; one that lasts over consecutive samples counts once

  // Waypoints of the plan, ascending, on the way to which something meets.
  std::vector<std::size_t> collidingWaypoints;

  double partVolumeMm3 = 0.0, beadLengthMm = 0.0;
  double pitchMm = 0.0; // of the grid of beads

  WorstPlaces worst;
};

struct Verification : RunFigures {
  bool passed = false; // every threshold kept and the text free of deviations

  // Material laid (supports and skirts apart) by part volume, at the controller's own speeds.
  double massRatio = 0.0;
  double depositedMm3 = 0.0, supportMm3 = 0.0;
  std::size_t limitViolations = 0; // as collisions are counted
  std::size_t deviations = 0;      // places where the text is not what was planned
  double maxDeviationMm = 0.0, maxDeviationRad = 0.0;

  bool armChecked = false; // false: the program says where the nozzle is, not where the arm is
  // On its controller (controller_time.h), waits included; of two laws for turns, by what the text
  // says.
  double durationS = 0.0;
  std::vector<double> motionS; // of each motion, by that law
  // Share of the printed length whose section is then off by more than 5 %; of two laws the worse.
  double flowErrorFraction = 0.0;

  std::vector<std::size_t>
      pointOf; // per motion: the trajectory's point, or kUnmatched (alignment.h)
  std::vector<TextPlace> motionPlaces; // per motion: where the text says it

  std::vector<ThresholdResult> results; // in the order of ReplayThresholds
  plan::Findings findings;              // stage "replay"
  std::vector<TextPlace> places;        // of each finding
};

// Runs the program, compares it motion by motion with the trajectory, lays its beads and judges.
// What is wrong with the program becomes findings, never an error.
//
// Preconditions (Error{Internal}): trajectory.dof == cell.dof(); its arrays are as long as they
// should be; the part has triangles; the platform is known. Throws Cancelled.
//
// Programs whose targets are ToolPoint carry no arm: limits and the arm's clearances are then not
// checked (armChecked == false), the nozzle's path, the head and the beads are.
// The result does not depend on the number of threads.
//
// `judged`, where given, holds the runs of programs that were written from the same plan, and takes
// up this one's: a run that is one of them but for what the grid of beads can't tell (run.h) is not
// judged a second time. Its text is compared, and its limits are checked, all the same.
// Example:
//   const replay::Verification verdict =
//       replay::replayProgram({read, toolPlan, trajectory, cell, process, part, plate}, {}, ctx);
Verification replayProgram(ReplayInput input, const ReplayThresholds& thresholds,
                           const base::RunContext& ctx, JudgedRuns* judged = nullptr);

} // namespace voluta::replay
