// Speed, rotation speed and blending of a motion from a KRL program's variables.
#pragma once

#include "base/text.h"
#include "plan/program.h"
#include "program/krl/krl_values.h"

#include <Eigen/Geometry>
#include <optional>

namespace voluta::program {

// Sets speed and acceleration of `motion`, whose target is known, and its time if the rotation
// takes longer than the path from `last` (frame_T_tcp of the preceding motion, in the same frame).
// Returns the reason if a value is invalid, else nullopt.
std::optional<base::Message> krlSpeed(const KrlVariables& variables,
                                      const std::optional<Eigen::Isometry3d>& last,
                                      plan::ProgramMotion& motion);
// Sets the blend of a motion with C_DIS. Returns as krlSpeed().
std::optional<base::Message> krlBlend(const KrlVariables& variables, plan::ProgramMotion& motion);

// Sets the motion's time if the rotation from `last` at `degPerS` takes longer than the path at the
// motion's speed.
void slowByRotation(const Eigen::Isometry3d& last, double degPerS, plan::ProgramMotion& motion);

} // namespace voluta::program
