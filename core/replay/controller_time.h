// How long a controller takes for a program's motions (plan::TimeModel).
//
// Straight motions go by a trapezoid of speed along the TCP's way: up at the acceleration that the
// text gives, else the model's, to the speed that the text gives, and down to what the corner at
// their end allows. In a blend of radius r the velocity turns by the corner's angle at a constant
// acceleration a (the parabola of executed_path.h): v^2 = a r / sin(angle / 2). Without a blend the
// arm stands, or passes at the junction deviation's speed, v^2 = a d c / (1 - c), c = cos(angle /
// 2) (Grbl's planner; Marlin, planner.cpp). Speeds are carried back and forth so that none is
// beyond what the motions ahead can brake from.
// A motion for which the text gives a time takes that: time rules over speed and acceleration
// (URScript manual, movel; RAPID manual, speeddata \T), and its speed at both ends is its mean.
// Joint motions go from rest to rest by the leading joint's trapezoid.
#pragma once

#include "plan/program.h"
#include "replay/executed_path.h"

#include <vector>

namespace voluta::replay {

// Which law holds for the TCP's turn.
enum class TurnLaw {
  Text,    // what the text says
  WaySpeed // the model's turnMmPerRad besides
};

// Seconds of joint motion m, m >= 1, at its text's speed with ramps of `radPerS2`; 0: without.
double jointMotionS(const ExecutedPath& path, std::size_t m, double radPerS2);

// Seconds of each motion; 0 for the first, which starts anywhere. Where the model does everything
// at once: the path's own durations.
std::vector<double> controllerTimes(const plan::ReadProgram& program, const ExecutedPath& path,
                                    TurnLaw law);

} // namespace voluta::replay
