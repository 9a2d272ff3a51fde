// What measured points come to, in a sentence or two for who measured them.
#pragma once

#include "base/text.h"
#include "robot/measured/measured_frames.h"

#include <cstddef>

namespace voluta::robot {

// Where the frame is: its origin, and its turns about the fixed x, then y, then z.
base::Message placeOf(const Eigen::Isometry3d& frame);
// How well the rows agree, and how sure that makes the result; that nothing tells, where there are
// just as many numbers as unknowns.
base::Message agreementOf(const Residual& residual, std::size_t rows);

} // namespace voluta::robot
