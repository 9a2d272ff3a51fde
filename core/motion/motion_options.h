// The options of the motion stage.
#pragma once

#include "base/parameters.h"
#include "base/units.h"
#include "collision/margins.h"
#include "plan/layer_event.h"
#include "plan/layer_times.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::motion {

// How the rotations about the nozzle that the ladder chose are smoothed.
enum class SmoothingMethod {
  None,
  Evened,   // Waves of a few waypoints are removed (even_turns.h)
  WholePath // Minimum jerk over each whole run (smooth_run.h): doubles the planning time
};

// Rotation of the nozzle about its own axis (tool_frames.h).
enum class NozzleRotation {
  Free, // Best for the arm: all rotations are tried
  Tangent,
  WorkAxis,
  Rodrigues
};

// Material that flows out beside the part.
struct PurgeOptions {
  double changeMm3 = 100.0; // after each tool change
  // Whether a nozzle that would be primed above the part goes beside it for that
  bool primesBeside = false;
};

// Shots into pockets.
struct ShotOptions {
  double flowMm3PerS = 0.0; // 0: the limit of the process
  double waitS = 0.0;       // after each
};

struct MotionOptions {
  int samples = 24;              // Number of rotations about the nozzle that are tried
  double rungMm = 5.0;           // Distance of the ladder graph's rungs along a path
  double rungRotationRad = 0.35; // Rotation of the nozzle after which the next rung comes sooner
  double maxStepRad = 0.25;      // Maximum joint step between waypoints
  // Maximum deviation of the nozzle from its straight path between targets
  double deviationMm = 0.02;
  // Head: directions keep more clearance where they can; the replay judges cases that the grid
  // cannot decide.
  collision::Margins printing{2.0, 2.0, -0.1};
  collision::Margins travelling{2.0, 2.0, 0.6}; // Head: beyond the eroded one
  double liftMm = 2.0;                          // Before a transfer
  double hopMm = 3.0;                           // Transfers no longer than this lift less
  double hopLiftMm = 1.0;
  std::uint64_t seed = 1;    // Of the sampling planner
  int treeIterations = 4000; // Of the sampling planner, per transfer
  NozzleRotation rotation = NozzleRotation::Free;
  SmoothingMethod smoothing = SmoothingMethod::Evened; // Of free rotations
  // Maximum tilt from the planned direction when whole paths are smoothed. 5 degrees reduces jerk
  // further, but some travels then lost their straight path.
  double leanRad = base::degreesToRadians(3.0);
  // Maximum deviation from the schedule of external axes that move along a path; sliding axes by
  // robot::fromAngle.
  double axesRad = base::degreesToRadians(15.0);
  double enoughMm = 10.0;     // Clearance above which no better pose is sought
  double nearCost = 1.0;      // Cost [rad] of a rung of the ladder graph at the clearance limit
  double wipeMm = 0.0;        // Along the bead before the lift, extruder off
  double minLayerTimeS = 0.0; // plan::LayerTimes
  PurgeOptions purge;
  std::vector<plan::LayerEvent> layerEvents; // of all items
  ShotOptions shot;

  // Limit of the jerk of every joint [rad/s3], sliding ones by robot::asAngle; 0: none
  // (jerk_limit.h)
  double maxJerk = 0.0;
  // Whole-path smoothing avoids the collisions that a learned indicator expects
  // (smoothing/learned_clearance.h); the true check still decides.
  bool learnedCollisions = false;
  // Where no branch of the arm reaches a whole path: changes the wrist's branch along the path
  // instead of lifting, where that is possible (ladder/branch_blend.h).
  bool blendsBranches = false;

  double leans() const { return smoothing == SmoothingMethod::WholePath ? leanRad : 0.0; }
};

// Keys: bodyClearanceMm, partClearanceMm, liftMm, wipeMm, nozzleRotation, redundancySamples,
// rotationSmoothing, tiltToleranceDeg, maxJerk, collisionModel, branchChange, pauseLayers,
// layerEvents, minLayerTimeS, maxLayerTimeS, purgeMm3, stitchFlow, stitchWait.
base::ParameterTable motionParameters();
// `layerEvents` are those of the values, for item 0. Throws as eventsAsked() (layer_event_text.h).
// Precondition: `values` are over a table with motionParameters().
MotionOptions motionOptions(const base::ParameterValues& values);
// Same precondition.
plan::LayerTimes layerTimes(const base::ParameterValues& values);

} // namespace voluta::motion
