// How a controller interprets the times and speeds in a program: parameters of a dialect, each with
// its source in docs/programs.md, Time. The default is a controller with unlimited acceleration and
// look-ahead.
#pragma once

namespace voluta::plan {

struct TimeModel {
  // Of straight motions whose text gives none; 0: unlimited.
  double accelerationMmPerS2 = 0.0;
  // Of joint motions whose text gives none; 0: unlimited.
  double jointAccelerationRadPerS2 = 0.0;
  // Joint speeds are whole percentages of an axis's maximum speed, which the text does not state.
  // The times of such motions cannot be compared with the plan's.
  bool jointsInPercent = false;
  double cycleS = 0.0; // Minimum duration of a motion
  // Number of motions that the controller looks ahead for a stop; 0: unlimited.
  int lookAhead = 0;
  // At a target without a blend the arm stops (0), or passes the corner at the speed allowed by an
  // arc that deviates from it by this distance (junction deviation).
  double junctionMm = 0.0;
  // Second speed law that some controllers are reported to use: a radian of TCP rotation takes as
  // long as this length of path; 0: no such law. Does not apply to motions for which the text gives
  // a time.
  double rotationMmPerRad = 0.0;
};

} // namespace voluta::plan
