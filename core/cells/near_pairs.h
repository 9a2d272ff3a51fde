// Bodies that are near each other whatever the arm does: what encloses them is, not they.
#pragma once

#include "robot/body.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::cells {

// The poses of all frames that bodies are in, at one pose of the arm (Kinematics::linkPoses,
// Cell::framePoses).
using Frames = std::vector<Eigen::Isometry3d>;

// Of two bodies in one frame each, mm; at most 0.5 mm off. Of two solids that are no capsules the
// smaller is taken as the capsule of about its size. Not above capMm.
double distanceOf(const robot::Body& a, const robot::Body& b, const Frames& frames, double capMm);

// The share of `poses`, 0..1, at which two bodies are nearer than nearMm.
double nearShare(const robot::Body& a, const robot::Body& b, const std::vector<Frames>& poses,
                 double nearMm);

} // namespace voluta::cells
