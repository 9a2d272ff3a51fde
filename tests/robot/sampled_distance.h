// Distances between bodies by sampling, for tests and searches: simple enough to trust by reading,
// and sharing nothing with core/collision. Capsules are sampled along their axis, other solids on
// their surface; a sample's distance to a solid is exact (from below for a prism's corners).
#pragma once

#include "robot/body.h"

#include <vector>

namespace voluta::test {

// Signed distance of a point (shape's own frame) to a solid: negative inside. mm.
double signedDistance(const Eigen::Vector3d& point, const robot::Shape& shape);

// A body's samples: each represents a ball of `radius` about `point` inside the solid (0 on the
// surface of one that is no capsule). Spacing about `spacingMm`.
struct Sample {
  Eigen::Vector3d point;
  double radius;
};
std::vector<Sample> samplesOf(const robot::Body& body, double spacingMm);

// Least distance from the samples of one body to the solids of another; negative when they overlap
// by that depth. The frames as poses in a common one. Not below `floorMm`: stops there.
double sampledDistance(const std::vector<Sample>& samples, const Eigen::Isometry3d& samplesPose,
                       const robot::Body& body, const Eigen::Isometry3d& bodyPose, double floorMm);

} // namespace voluta::test
