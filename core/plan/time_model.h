// What a controller makes of the times and speeds in a program: figures of a dialect's row, each
// with its source in docs/programs.md, Time. The default is a controller that does everything at
// once.
#pragma once

namespace voluta::plan {

struct TimeModel {
  // Of straight motions whose text gives none; 0: any speed at once.
  double accelerationMmPerS2 = 0.0;
  // Of joint motions whose text gives none; 0: any speed at once.
  double jointAccelerationRadPerS2 = 0.0;
  // Joint speeds come in whole percent of what an axis can, which the text doesn't tell: such a
  // motion's time is no figure to hold against the plan's.
  bool jointsInPercent = false;
  double cycleS = 0.0; // no motion that moves is shorter
  // How far ahead the controller looks for a place where it has to stand, in motions; 0: to the
  // end.
  int lookAhead = 0;
  // A target without a blend: the arm stands there (0), or passes it as fast as if the corner were
  // rounded by an arc that leaves it by so much (junction deviation).
  double junctionMm = 0.0;
  // A second law that some report: a radian of the TCP's turn takes as long as so much of its way;
  // 0: there is none. Motions for which the text gives a time are not concerned.
  double turnMmPerRad = 0.0;
};

} // namespace voluta::plan
