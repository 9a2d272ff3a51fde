#include "cells/near_pairs.h"

#include "collision/shape_distance.h"

#include <algorithm>

namespace voluta::cells {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::Capsule;

Capsule between(const Vector3d& p0, const Vector3d& p1, double radius) {
  const Vector3d along = p1 - p0;
  const double length = along.norm(), cut = std::min(radius, 0.5 * length);
  const Vector3d end = length > 0.0 ? Vector3d(cut / length * along) : Vector3d::Zero();
  return {p0 + end, p1 - end, radius};
}

Capsule asCapsule(const robot::Shape& shape) {
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return *capsule;
  if (const auto* frustum = std::get_if<robot::Frustum>(&shape))
    return between(frustum->p0, frustum->p1, 0.5 * (frustum->r0 + frustum->r1));
  if (const auto* box = std::get_if<robot::Box>(&shape)) {
    Eigen::Index longest = 0;
    box->half.maxCoeff(&longest);
    Vector3d half = box->half;
    std::sort(half.begin(), half.end());
    const Vector3d along = half[2] * Vector3d::Unit(longest);
    return between(box->frame_T_box * -along, box->frame_T_box * along, half[1]);
  }
  const auto& prism = std::get<robot::Prism>(shape);
  double radius = 0.0;
  for (const Eigen::Vector2d& p : prism.polygon)
    radius = std::max(radius, p.norm());
  const Vector3d middle(0, 0, 0.5 * (prism.zMin + prism.zMax));
  return {middle, middle, radius};
}

double distanceOf(const robot::Shape& a, const Isometry3d& poseA, const robot::Shape& b,
                  const Isometry3d& poseB, double capMm) {
  const Capsule ca = asCapsule(a), cb = asCapsule(b);
  const bool aIsCapsule = std::holds_alternative<Capsule>(a);
  const bool bIsCapsule = std::holds_alternative<Capsule>(b);
  const bool takeA = aIsCapsule != bIsCapsule ? aIsCapsule : ca.radius <= cb.radius;
  const auto& [capsule, capsulePose] = takeA ? std::tie(ca, poseA) : std::tie(cb, poseB);
  const auto& [other, otherPose] = takeA ? std::tie(b, poseB) : std::tie(a, poseA);
  return collision::capsuleDistance(
      {capsulePose * capsule.p0, capsulePose * capsule.p1, capsule.radius},
      collision::place(other, otherPose), capMm);
}

} // namespace

double distanceOf(const robot::Body& a, const robot::Body& b, const Frames& frames, double capMm) {
  double minimum = capMm;
  for (const robot::Shape& one : a.shapes)
    for (const robot::Shape& other : b.shapes)
      minimum = std::min(minimum, distanceOf(one, frames[static_cast<std::size_t>(a.frame)], other,
                                             frames[static_cast<std::size_t>(b.frame)], minimum));
  return minimum;
}

double nearShare(const robot::Body& a, const robot::Body& b, const std::vector<Frames>& poses,
                 double nearMm) {
  const auto near = std::count_if(poses.begin(), poses.end(), [&](const Frames& frames) {
    return distanceOf(a, b, frames, nearMm) < nearMm;
  });
  return poses.empty() ? 0.0 : static_cast<double>(near) / static_cast<double>(poses.size());
}

} // namespace voluta::cells
