// Moves solids within the frame of their body.
#pragma once

#include "robot/body.h"

namespace voluta::robot {

// Returns the solid transformed by `by` in its own frame of reference. Precondition: not a prism,
// which is always upright in its frame.
Shape moved(Shape shape, const Eigen::Isometry3d& by);

} // namespace voluta::robot
