// Results of measurements as sentences for users.
#pragma once

#include "base/text.h"
#include "robot/measured/measured_frames.h"

#include <cstddef>

namespace voluta::robot {

// Returns the frame's origin and its rotations about the fixed x, then y, then z.
base::Message placeOf(const Eigen::Isometry3d& frame);
// Returns how well the rows agree and how accurate the result is; without redundant rows, that the
// error is unknown.
base::Message agreementOf(const Residual& residual, std::size_t rows);

} // namespace voluta::robot
