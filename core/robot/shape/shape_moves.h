// Solids moved within the frame of their body.
#pragma once

#include "robot/body.h"

namespace voluta::robot {

// `by` applied to the solid, in the frame that it is given in. Precondition: no prism, which stands
// upright in its frame.
Shape moved(Shape shape, const Eigen::Isometry3d& by);

} // namespace voluta::robot
