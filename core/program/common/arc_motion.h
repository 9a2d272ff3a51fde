// Arcs in motions that were read.
#pragma once

#include "base/text.h"
#include "plan/program.h"

#include <Eigen/Core>
#include <optional>

namespace voluta::program {

// Sets the way of a motion to a pose, which begins at `from`, to the arc via `via`; all in the
// frame of frame_T_tcp. Returns an error if the points are on a line.
std::optional<base::Message> setArc(const Eigen::Vector3d& from, const Eigen::Vector3d& via,
                                    plan::ProgramMotion& motion);

// Returns the length of a motion to a pose from `from`, along its way.
double lengthMm(const Eigen::Vector3d& from, const plan::ProgramMotion& motion);

} // namespace voluta::program
