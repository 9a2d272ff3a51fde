// Search for pairs of bodies that are near each other at any pose because their enclosing solids
// are.
#pragma once

#include "robot/body.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::cells {

// The poses of all frames of bodies for one pose of the arm (Kinematics::linkPoses,
// Cell::framePoses).
using Frames = std::vector<Eigen::Isometry3d>;

// Returns the distance of two bodies [mm], each rigid in one frame, with an error of at most 0.5 mm
// and limited to capMm. Of two solids that are not capsules, the smaller one is replaced by a
// capsule of about its size.
double distanceOf(const robot::Body& a, const robot::Body& b, const Frames& frames, double capMm);

// Returns the share of `poses`, 0..1, at which two bodies are closer than nearMm.
double nearShare(const robot::Body& a, const robot::Body& b, const std::vector<Frames>& poses,
                 double nearMm);

} // namespace voluta::cells
