// What a KRL program's variables say of how a motion goes: its speed, its turn, its corner.
#pragma once

#include "base/text.h"
#include "plan/program.h"
#include "program/krl/krl_values.h"

#include <Eigen/Geometry>
#include <optional>

namespace voluta::program {

// Fills in speed and acceleration of `motion`, whose target is known; where turning takes longer
// than the way from `last` (frame_T_tcp of the motion before, in the same frame), its time.
// The reason why it cannot be; nothing: it was.
std::optional<base::Message> krlSpeed(const KrlVariables& variables,
                                      const std::optional<Eigen::Isometry3d>& last,
                                      plan::ProgramMotion& motion);
// Likewise its blend, of a motion with C_DIS.
std::optional<base::Message> krlBlend(const KrlVariables& variables, plan::ProgramMotion& motion);

// Where turning from `last` at `degPerS` takes longer than the way at the motion's speed, the
// motion's time is that.
void slowByTurn(const Eigen::Isometry3d& last, double degPerS, plan::ProgramMotion& motion);

} // namespace voluta::program
