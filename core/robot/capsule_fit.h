// Capsules around points, for links that come as meshes.
#pragma once

#include "robot/body.h"

#include <vector>

namespace voluta::robot {

// The smallest, by volume, of those along the points' principal axes and along `alsoAlong` (no
// unit needed; zero: none): around each axis as thin as it can be. Ends and radius on whole tenths
// of a millimetre, the radius up, so that every point is in it as it is written.
// Precondition: points.
Capsule enclosingCapsule(const std::vector<Eigen::Vector3d>& points,
                         const Eigen::Vector3d& alsoAlong);

} // namespace voluta::robot
