// Changes the arm's branch along a path, spread over several waypoints, so that the nozzle need not
// be lifted (Castelli, 4.6.3).
#pragma once

#include "motion/bead_run.h"
#include "motion/motion_scene.h"

#include <cstdint>
#include <optional>

namespace voluta::motion {

enum class BlendRefusal : std::uint8_t {
  None,
  Apart,    // the runs do not meet, or external axes move
  ArmFlips, // shoulder or elbow change: the nozzle cannot stay on the path meanwhile
  Tilts,    // the wrist is stretched so far away that the nozzle would tilt beyond the tolerance
  Limits,   // a joint would exceed its limits
  Collides, // of the arm or the head
  Jumps     // a controller that moves the nozzle straight would not follow
};

struct BlendedRun {
  std::optional<Run> run; // nullopt: refused
  BlendRefusal why = BlendRefusal::None;
  double speedShare = 0.0; // largest joint speed at the wanted speeds, relative to its limit
  std::size_t points = 0;  // over which the branch changes
};

// Joins two runs of a path if `before` ends at the waypoint where `after` begins. Before it the
// wrist turns to the other branch with the joint between its axes bent as it was, behind it that
// joint passes its stretched pose; the tip stays on the path and the direction within `coneRad` of
// the planned one. The change takes as few points as keep all joints below half of their speed
// limits, or else as many as make them slowest. Steps are divided so that the nozzle stays on its
// line; every point is checked for limits and collisions. Precondition: both runs are valid.
BlendedRun blendBranches(const MotionScene& scene, const Run& before, const Run& after,
                         double coneRad);

} // namespace voluta::motion
