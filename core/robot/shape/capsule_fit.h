// Capsules around points, for links that come as meshes.
#pragma once

#include "robot/body.h"
#include "robot/shape/triangle_cut.h"

#include <vector>

namespace voluta::robot {

// The smallest, by volume, of those along the points' principal axes and along `alsoAlong` (no
// unit needed; zero: none): around each axis as thin as it can be. Ends and radius on whole tenths
// of a millimetre, the radius up, so that every point is in it as it is written.
// Precondition: points.
Capsule enclosingCapsule(const std::vector<Eigen::Vector3d>& points,
                         const Eigen::Vector3d& alsoAlong);

// Up to `most` capsules that hold every triangle between them: the mesh is cut by planes, each
// where it saves most volume, as long as a cut saves a sixth of the whole. Each part's capsule as
// enclosingCapsule has it. Where to cut is looked for on some thousand triangles.
// Preconditions: triangles, most >= 1.
std::vector<Capsule> enclosingCapsules(const std::vector<Corners>& triangles,
                                       const Eigen::Vector3d& alsoAlong, int most);

} // namespace voluta::robot
