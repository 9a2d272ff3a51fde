#include "robot/overlaps.h"

#include <algorithm>
#include <random>

namespace voluta::robot {

namespace {

using Eigen::Vector3d;

Capsule asCapsule(const Shape& shape) {
  const auto inside = [](const Vector3d& p0, const Vector3d& p1, double radius) {
    const Vector3d along = p1 - p0;
    const double length = along.norm(), cut = std::min(radius, 0.5 * length);
    const Vector3d end = length > 0.0 ? Vector3d(cut / length * along) : Vector3d::Zero();
    return Capsule{p0 + end, p1 - end, radius};
  };
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return *capsule;
  if (const auto* frustum = std::get_if<Frustum>(&shape))
    return inside(frustum->p0, frustum->p1, 0.5 * (frustum->r0 + frustum->r1));
  if (const auto* box = std::get_if<Box>(&shape)) {
    Eigen::Index longest = 0;
    box->half.maxCoeff(&longest);
    Vector3d half = box->half;
    std::sort(half.begin(), half.end());
    const Vector3d along = half[2] * Vector3d::Unit(longest);
    return inside(box->frame_T_box * -along, box->frame_T_box * along, half[1]);
  }
  return {Vector3d::Zero(), Vector3d::Zero(), 0.0};
}

// Between the axes: the least over the four ends and, where it is inside both, the common
// perpendicular.
double between(const Capsule& a, const Capsule& b) {
  const auto toSegment = [](const Vector3d& p, const Capsule& c) {
    const Vector3d along = c.p1 - c.p0;
    const double square = along.squaredNorm();
    const double at = square > 0.0 ? std::clamp((p - c.p0).dot(along) / square, 0.0, 1.0) : 0.0;
    return (p - c.p0 - at * along).norm();
  };
  double least =
      std::min({toSegment(a.p0, b), toSegment(a.p1, b), toSegment(b.p0, a), toSegment(b.p1, a)});
  const Vector3d u = a.p1 - a.p0, v = b.p1 - b.p0, w = b.p0 - a.p0, n = u.cross(v);
  if (const double square = n.squaredNorm(); square > 1e-12) {
    const double s = w.cross(v).dot(n) / square, t = w.cross(u).dot(n) / square;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0)
      least = std::min(least, std::abs(w.dot(n)) / std::sqrt(square));
  }
  return least - a.radius - b.radius;
}

bool overlap(const std::vector<Capsule>& a, const Eigen::Isometry3d& poseA,
             const std::vector<Capsule>& b, const Eigen::Isometry3d& poseB) {
  const auto moved = [](const Capsule& c, const Eigen::Isometry3d& pose) {
    return Capsule{pose * c.p0, pose * c.p1, c.radius};
  };
  return std::any_of(a.begin(), a.end(), [&](const Capsule& one) {
    const Capsule here = moved(one, poseA);
    return std::any_of(b.begin(), b.end(), [&](const Capsule& other) {
      return between(here, moved(other, poseB)) < 0.0;
    });
  });
}

} // namespace

std::vector<std::pair<int, int>> mostlyOverlapping(const RobotModel& robot) {
  constexpr int kPoses = 400;
  std::vector<std::vector<Capsule>> solids;
  for (const Body& link : robot.links) {
    std::vector<Capsule>& capsules = solids.emplace_back();
    for (const Shape& shape : link.shapes)
      capsules.push_back(asCapsule(shape));
  }
  const std::size_t count = robot.links.size();
  std::vector<int> overlaps(count * count, 0);
  std::mt19937_64 random(1);
  std::vector<Eigen::Isometry3d> poses;
  JointVector q(robot.dof());
  for (int n = 0; n < kPoses; ++n) {
    for (int i = 0; i < robot.dof(); ++i) {
      const JointLimits& limit = robot.limits[static_cast<std::size_t>(i)];
      const double share = static_cast<double>(random() >> 11) * 0x1p-53;
      q[i] = limit.min + share * (limit.max - limit.min);
    }
    robot.kinematics->linkPoses(q, poses);
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = a + 1; b < count; ++b)
        overlaps[a * count + b] +=
            overlap(solids[a], poses[static_cast<std::size_t>(robot.links[a].frame)], solids[b],
                    poses[static_cast<std::size_t>(robot.links[b].frame)])
                ? 1
                : 0;
  }
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b)
      if (robot.links[b].frame - robot.links[a].frame > 1 && 2 * overlaps[a * count + b] > kPoses)
        pairs.emplace_back(static_cast<int>(a), static_cast<int>(b));
  return pairs;
}

} // namespace voluta::robot
