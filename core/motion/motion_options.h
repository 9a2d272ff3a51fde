// What can be asked of the motion stage.
#pragma once

#include "base/parameters.h"
#include "base/units.h"
#include "collision/cell_collision.h"

#include <cstdint>

namespace voluta::motion {

// What is done to the turns about the nozzle that the ladder gave.
enum class TurnMethod {
  None,
  Evened,   // waves of a few waypoints are taken out (even_turns.h)
  WholePath // the least jerk over each whole run (smooth_run.h): twice the motion's time
};

// How the nozzle stands about its own axis (tool_frames.h).
enum class NozzleTurn {
  Free, // as the arm goes best: all turns are tried
  Tangent,
  WorkAxis,
  Rodrigues
};

struct MotionOptions {
  int samples = 24;          // turns about the nozzle that are tried
  double rungMm = 5.0;       // distance of rungs of the ladder graph along a path
  double rungTurnRad = 0.35; // and the turn of the nozzle after which there is one sooner
  double maxStepRad = 0.25;  // largest joint step between waypoints
  double deviationMm = 0.02; // of the nozzle from its straight way between targets
  // Head: directions have kept more where they could; what the grid leaves in doubt is the
  // replay's to judge.
  collision::Margins printing{2.0, 2.0, -0.1};
  collision::Margins travelling{2.0, 2.0, 0.6}; // head: beyond the eroded one
  double liftMm = 2.0;                          // before a transfer
  double hopMm = 3.0;                           // transfers no longer than this lift less
  double hopLiftMm = 1.0;
  std::uint64_t seed = 1;    // of the sampling planner
  int treeIterations = 4000; // of the sampling planner, a transfer
  NozzleTurn turn = NozzleTurn::Free;
  TurnMethod smoothing = TurnMethod::Evened; // of free turns
  // How far directions may lean where whole paths are smoothed. At 5 degrees jerk is less still,
  // but some travels were found to lose their straight way.
  double leanRad = base::degreesToRadians(3.0);
  // How far external axes that move along a path may then go from where their schedule has them;
  // slides by robot::fromTurn.
  double axesRad = base::degreesToRadians(15.0);
  double enoughMm = 10.0; // further from everything than that no pose is worth seeking
  double nearCost = 1.0;  // rad: of a rung of the ladder graph where something is just not met
  double wipeMm = 0.0;    // along the bead before the lift, the extruder off

  double leans() const { return smoothing == TurnMethod::WholePath ? leanRad : 0.0; }
};

// Keys: bodyClearanceMm, partClearanceMm, liftMm, wipeMm, nozzleTurn, redundancySamples,
// turnSmoothing, directionConeDeg.
base::ParameterTable motionParameters();
// Throws nothing when `values` are over a table with motionParameters().
MotionOptions motionOptions(const base::ParameterValues& values);

} // namespace voluta::motion
