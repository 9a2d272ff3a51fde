// The verdict on a program read back from its text (docs/design.md, Replay).
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/finding.h"
#include "plan/layer_times.h"
#include "plan/program.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "platform/platform_solid.h"
#include "process/tooling.h"
#include "replay/covering_times.h"
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

// The trajectory before its points were merged for the program; null: none were.
struct WholePlan {
  const plan::Trajectory* trajectory = nullptr;
  std::span<const std::size_t> mergedPoint; // per point: the one that ends its merged motion
};

// The program as read, the plan it was written from, and the part it has to print.
struct ReplayInput {
  plan::ReadProgram program; // freed after the comparison, as it takes hundreds of bytes per motion
  const plan::ToolPlan& plan;
  const plan::Trajectory& trajectory;
  const robot::Cell& cell;
  process::Tooling tooling;
  // placed, without the volume inside the ground: work frame, mm
  const geometry::TriangleMesh& part;
  const platform::PlatformSolid& platform; // ground below the first beads
  // point of the trajectory at which the text begins: the rest of a print
  std::size_t firstPoint = 0;
  // Per point of the trajectory: its number in the trajectory shared by the programs that are
  // compared with each other; empty: the same number.
  std::span<const std::size_t> commonPoint = {};
  // First triangle of each item in `part`; empty: the job has one item.
  std::span<const std::size_t> firstTriangle = {};
  WholePlan whole = {}; // the reference of the path's deviation
  plan::LayerTimes layerTimes = {};
};

// The limits that a program must keep (docs/design.md, Replay).
struct ReplayThresholds {
  // Of quality: beyond these the program is safe to run, but does not print the part as asked.
  double coveredMin = 0.97;      // share of the part's volume inside beads, thin places left out
  double unsupportedMax = 0.005; // share of bead length with nothing below
  double overfillMax = 0.03;     // bead volume outside the part, by part volume
  double massTolerance = 0.03;   // |massRatio - 1|
  double thinMax = 0.03;         // share of the part's volume that is open and thin
  bool bridgesMaySag = false;    // spans as process::saggingBridgeMm() are held
  // Of safety: beyond these the program must not run.
  std::size_t collisionsMax = 0;
  std::size_t limitViolationsMax = 0;
  double deviationMaxMm = 0.05; // of the executed nozzle path from the planned one
  double flowErrorMax = 0.01;   // share of the printed length with a wrong section
};

struct ThresholdResult {
  std::string name; // the report's key, e.g. "coveredFraction"
  double value = 0.0, limit = 0.0;
  bool passed = false;
  bool concernsSafety = false;
};

// The place of a finding or motion in the program's text, 1-based; line 0: no particular line.
struct TextPlace {
  std::size_t file = 0, line = 0;
};

// Figures of one item among several, as the figures of the whole job below.
struct ItemFigures {
  double coveredFraction = 0.0, unsupportedFraction = 0.0;
  double intendedMm3 = 0.0, massRatio = 0.0;
  double thinMm3 = 0.0, thinFraction = 0.0;
};

// Figures of a run: its beads and its collisions.
struct RunFigures {
  // Share of the intended volume without thinMm3 that is inside beads. Of a part with sparse infill
  // only the shell is measured; the interior counts as covered, and its amount shows in the mass.
  double coveredFraction = 0.0;
  // Volume that no bead fills and that is narrower than the narrowest bead (thin_cells.h), and its
  // share of the intended volume. 0 unless layers are horizontal.
  double thinMm3 = 0.0, thinFraction = 0.0;
  double unsupportedFraction = 0.0;
  double halfCarriedFraction = 0.0; // share of bead length supported on less than half its width
  // longest continuous length of a bead with nothing directly below
  double longestUnsupportedMm = 0.0;
  double overfillFraction = 0.0; // outside the part, plus excess, by part volume
  double excessFraction = 0.0;   // the part of overfillFraction that found no room
  std::size_t collisions = 0;    // contacts; one that lasts over consecutive samples counts once

  // Waypoints of the plan, ascending, with a collision on the way to them.
  std::vector<std::size_t> collidingWaypoints;

  double partVolumeMm3 = 0.0, beadLengthMm = 0.0;
  double intendedMm3 = 0.0; // of the part, without the volume that sparse infill leaves open
  double pitchMm = 0.0;     // of the bead grid

  // Of each item of a job of several, which all have to keep the limits; empty: the job has one.
  std::vector<ItemFigures> items;
  LayerTimeFigures layerTimes;
  WorstPlaces worst;
};

struct Verification : RunFigures {
  bool safeToRun = false; // the thresholds of safety kept and no deviations in the text
  bool passed = false;    // safe to run, and all other thresholds kept too

  // Deposited material (without supports and skirts) by intended volume, at the controller's own
  // speeds. Material may be missing in thin places: amounts between the intended volume without
  // them and the whole have the ratio 1, and less is measured by the volume without them.
  double massRatio = 0.0;
  double depositedMm3 = 0.0, supportMm3 = 0.0, tapeMm3 = 0.0;
  std::vector<double> depositedOfItemMm3; // of each item of a job of several
  std::size_t limitViolations = 0;        // counted like collisions
  std::size_t deviations = 0;             // places where the text differs from the plan
  double maxDeviationMm = 0.0, maxDeviationRad = 0.0;

  bool armChecked = false; // false: the program states only the nozzle's pose, not the arm's
  // On its controller (controller_time.h), waits included; if there are two laws for rotations, by
  // the one that the text states.
  double durationS = 0.0;
  std::vector<double> motionS; // of each motion, by the same law
  // Share of the printed length whose section is then off by more than 5 %; the worse of two laws.
  double flowErrorFraction = 0.0;

  std::vector<std::size_t>
      pointOf; // per motion: the trajectory's point, or kUnmatched (alignment.h)
  std::vector<TextPlace> motionPlaces; // per motion: its line in the text

  std::vector<ThresholdResult> results; // in the order of ReplayThresholds
  plan::Findings findings;              // stage "replay"
  std::vector<TextPlace> places;        // of each finding
};

// Runs the program, compares it motion by motion with the trajectory, deposits its beads and judges
// the result. Defects of the program become findings, never errors.
//
// Preconditions (Error{Internal}): trajectory.dof == cell.dof(); its arrays have matching lengths;
// the part has triangles; the platform is known. Throws Cancelled.
//
// Programs with ToolPoint targets contain no arm: the limits and clearances of the arm are then not
// checked (armChecked == false); the nozzle's path, the head and the beads are. The result does not
// depend on the number of threads.
// Example:
//   const replay::Verification verdict =
//       replay::replayProgram({read, toolPlan, trajectory, cell, tooling, part, plate}, {}, ctx);
Verification replayProgram(ReplayInput input, const ReplayThresholds& thresholds,
                           const base::RunContext& ctx);

} // namespace voluta::replay
