// Enclosing capsules, for links that are given as meshes.
#pragma once

#include "robot/body.h"
#include "robot/shape/triangle_cut.h"

#include <vector>

namespace voluta::robot {

// Returns the capsule with the smallest volume among those along the points' principal axes and
// along `alsoAlong` (need not be normalized; zero: none), each as thin as possible around its axis.
// Ends and radius are rounded to tenths of a millimetre, the radius up, so that every point is
// inside the rounded capsule. Precondition: points is not empty.
Capsule enclosingCapsule(const std::vector<Eigen::Vector3d>& points,
                         const Eigen::Vector3d& alsoAlong);

// Returns up to `maxParts` capsules that together contain every triangle. The mesh is cut by
// planes, each where it saves the most volume, as long as a cut saves a sixth of the whole. Each
// part gets its enclosingCapsule(). Cuts are searched on some thousand triangles. Preconditions:
// triangles is not empty, maxParts >= 1.
std::vector<Capsule> enclosingCapsules(const std::vector<Corners>& triangles,
                                       const Eigen::Vector3d& alsoAlong, int maxParts);

} // namespace voluta::robot
