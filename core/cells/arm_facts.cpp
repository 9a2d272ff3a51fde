#include "cells/arm_facts.h"

#include "base/error.h"
#include "base/units.h"
#include "collision/shape_distance.h"
#include "geometry/directions.h"
#include "geometry/least_turn.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace voluta::cells {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::JointVector;

constexpr std::size_t kPoses = 4000;

// The line about which a joint turns the links behind it, for an arm at q.
struct Line {
  Vector3d point, direction;
};
Line axisOf(const robot::RobotModel& robot, JointVector q, int joint) {
  constexpr double kTestRad = 1.0;
  const Isometry3d from = robot.kinematics->flange(q);
  q[joint] += kTestRad;
  const Isometry3d move = robot.kinematics->flange(q) * from.inverse();
  const Eigen::AngleAxisd rotation(move.linear());
  const Vector3d d = rotation.angle() > 0.0 ? Vector3d(rotation.axis()) : Vector3d::UnitZ();
  // (1 - R) p = t has a line of solutions; the least-squares solution is the one nearest to the
  // origin.
  const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity() - move.linear();
  return {rest.completeOrthogonalDecomposition().solve(move.translation()), d};
}

// Returns the height of the arm's foot: z = 0 of its base, unless the base's solids exclude that.
// Capsules extend beyond the enclosed geometry by at most their radius.
double footOf(const robot::RobotModel& robot) {
  double low = 0.0, high = 0.0; // bounds for the solids' underside
  bool first = true;
  for (const robot::Body& link : robot.links) {
    if (link.frame != 0)
      continue;
    for (const robot::Shape& shape : link.shapes) {
      double bottom = 0.0, over = 0.0;
      if (const auto* capsule = std::get_if<robot::Capsule>(&shape)) {
        bottom = std::min(capsule->p0.z(), capsule->p1.z());
        over = capsule->radius;
      } else if (const auto* frustum = std::get_if<robot::Frustum>(&shape)) {
        bottom = std::min(frustum->p0.z(), frustum->p1.z());
      } else if (const auto* box = std::get_if<robot::Box>(&shape)) {
        bottom = box->frame_T_box.translation().z() -
                 box->frame_T_box.linear().row(2).cwiseAbs().dot(box->half);
      }
      low = first ? bottom - over : std::min(low, bottom - over);
      high = first ? bottom : std::min(high, bottom);
      first = false;
    }
  }
  return std::clamp(0.0, low, high);
}

} // namespace

std::vector<JointVector> drawnPoses(const std::vector<robot::JointLimits>& limits,
                                    std::size_t count) {
  std::mt19937_64 random(1);
  std::vector<JointVector> poses;
  for (std::size_t n = 0; n < count; ++n) {
    JointVector q(static_cast<Eigen::Index>(limits.size()));
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const double share = static_cast<double>(random() >> 11) * 0x1p-53;
      q[static_cast<Eigen::Index>(i)] = limits[i].min + share * (limits[i].max - limits[i].min);
    }
    poses.push_back(std::move(q));
  }
  return poses;
}

ArmFacts armFacts(const robot::RobotModel& robot) {
  base::require(robot.dof() > 0 && !robot.links.empty(), "an arm with links");
  ArmFacts facts;
  std::vector<JointVector> poses = drawnPoses(robot.limits, kPoses);
  JointVector middle(robot.dof());
  for (int i = 0; i < robot.dof(); ++i) {
    const robot::JointLimits& limit = robot.limits[static_cast<std::size_t>(i)];
    middle[i] = 0.5 * (limit.min + limit.max);
  }
  const Line first = axisOf(robot, poses.front(), 0);
  facts.uprightAxis = std::abs(first.direction.z()) > std::cos(base::degreesToRadians(5.0));
  facts.foot = first.point;
  facts.foot.z() = footOf(robot);

  Vector3d ahead = Vector3d::Zero();
  for (JointVector& q : poses) {
    q[0] = middle[0];
    Vector3d out = robot.kinematics->flange(q).translation() - facts.foot;
    out.z() = 0.0;
    facts.reachMm = std::max(facts.reachMm, out.norm());
    ahead += out / static_cast<double>(poses.size());
  }
  // An arm that reaches as far backwards over itself as forwards has no preferred side.
  constexpr double kSided = 0.2;
  if (ahead.norm() > kSided * facts.reachMm) {
    const double step = base::degreesToRadians(15.0), angle = std::atan2(ahead.y(), ahead.x());
    facts.aheadRad = step * std::round(angle / step);
  }

  const int last = robot.dof() - 1;
  if (robot.kinematics->kindOf(last) == robot::JointKind::Turning) {
    const Line axis = axisOf(robot, middle, last);
    std::vector<Isometry3d> links;
    robot.kinematics->linkPoses(middle, links);
    const Isometry3d& flange = links.back();
    const Vector3d inFlange = flange.linear().transpose() * axis.direction;
    constexpr double kAlong = 0.9;
    if (std::abs(inFlange.z()) < kAlong) {
      const Vector3d before = links[links.size() - 3].translation();
      const double away = (flange.translation() - before).dot(axis.direction);
      facts.flange_R_outward =
          geometry::shortestRotation(Vector3d::UnitZ(), away < 0.0 ? Vector3d(-inFlange) : inFlange)
              .toRotationMatrix();
    }
  }
  return facts;
}

} // namespace voluta::cells
