// Model of the time a controller takes for a program's motions (plan::TimeModel).
//
// Straight motions follow a trapezoidal speed profile along the TCP's path: they accelerate at the
// value given in the text, otherwise at the model's, to the speed given in the text, and brake to
// the speed that the corner at their end allows. In a blend of radius r the velocity turns by the
// corner's angle at a constant acceleration a (the parabola of executed_path.h): v^2 = a r /
// sin(angle / 2). Without a blend the arm stops, or passes at the junction deviation's speed, v^2 =
// a d c / (1 - c), c = cos(angle / 2) (Grbl's planner; Marlin, planner.cpp). A backward and a
// forward pass limit the speeds so that the motions ahead suffice for braking. A motion with a time
// in the text takes that time: time takes precedence over speed and acceleration (URScript manual,
// movel; RAPID manual, speeddata \T). Its speed at both ends is its mean speed. Joint motions run
// from rest to rest with the leading joint's trapezoidal profile.
#pragma once

#include "plan/program.h"
#include "replay/executed_path.h"

#include <vector>

namespace voluta::replay {

// The limit on the TCP's rotation.
enum class RotationLaw {
  Text,     // as stated in the text
  PathSpeed // the text and the model's rotationMmPerRad
};

// Returns the duration [s] of joint motion m, m >= 1, at the text's speed with ramps of `radPerS2`;
// 0: without ramps.
double jointMotionS(const ExecutedPath& path, std::size_t m, double radPerS2);

// Returns the duration [s] of each motion; 0 for the first, whose start is unknown. If the model
// accelerates instantaneously, these are the path's own durations.
std::vector<double> controllerTimes(const plan::ReadProgram& program, const ExecutedPath& path,
                                    RotationLaw law);

} // namespace voluta::replay
