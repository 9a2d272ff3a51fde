#include "collision/way_clearance.h"

#include "collision/growing_part.h"
#include "robot/cell.h"

#include <algorithm>
#include <cmath>

namespace voluta::collision {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::JointVector;

namespace {
// of all joints together, for which speeds are considered constant
constexpr double kMaxRotationRad = 0.25;
constexpr double kStep = 1e-4;       // rad or mm, of the finite differences
constexpr double kInexact = 1.001;   // error bound of the speeds by finite differences
constexpr double kSameSpeed = 1e-4;  // mm and rad per unit of the joint
constexpr double kDistanceMm = 1e-4; // accuracy of distances

// Motion of a frame per unit of a joint: the speed of its point at the base's origin, and its
// angular velocity.
struct Twist {
  Vector3d speed = Vector3d::Zero(), rotation = Vector3d::Zero();

  bool isSame(const Twist& other) const {
    return (speed - other.speed).norm() < kSameSpeed &&
           (rotation - other.rotation).norm() < kSameSpeed;
  }
  // Upper bound for all points of a sphere.
  double upperBound(const Ball& ball) const {
    return kInexact *
           ((speed + rotation.cross(ball.centre)).norm() + rotation.norm() * ball.radius);
  }
};

Twist twistBetween(const Isometry3d& from, const Isometry3d& to) {
  const Isometry3d moved = to * from.inverse(Eigen::Isometry);
  const Eigen::Matrix3d& r = moved.linear();
  return {moved.translation() / kStep,
          Vector3d(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)) / (2.0 * kStep)};
}
} // namespace

struct MotionClearance::Stretch {
  const Contact& pair;
  std::size_t before;
  JointVector from, to;
  double fromMm, toMm;   // distances, or lower bounds
  double displacementMm; // upper bound of the relative displacement of points of the two
};

struct MotionClearance::Speeds {
  std::vector<double> step;              // per moving joint
  double angleRad = 0.0;                 // of all of them
  std::vector<std::vector<Twist>> twist; // per moving joint, per frame
  std::vector<Ball> ball;                // as balls_, in the base
};

MotionClearance::MotionClearance(const CellCollision& collision, const GrowingPart& part)
    : collision_(collision), part_(part), pairs_(collision.clearancePairs()) {
  for (std::size_t b = 0; b < collision.cell().bodies().size(); ++b)
    balls_.push_back(collision.ballAbout(static_cast<int>(b)));
  const Eigen::AlignedBox3d box = part.bounds();
  balls_.push_back(box.isEmpty() ? Ball{Vector3d::Zero(), 0.0}
                                 : Ball{box.center(), 0.5 * box.diagonal().norm()});
}

double MotionClearance::along(const JointVector& from, const JointVector& to, std::size_t before,
                              double minMm, double detour) const {
  const robot::Cell& cell = collision_.cell();
  double angle = 0.0;
  for (Eigen::Index j = 0; j < from.size(); ++j)
    if (cell.limits()[static_cast<std::size_t>(j)].kind == robot::JointKind::Turning)
      angle += std::abs(to[j] - from[j]);
  const int pieces = std::max(1, static_cast<int>(std::ceil(angle / kMaxRotationRad)));
  JointVector last = from;
  for (int k = 1; k <= pieces; ++k) {
    const JointVector next = from + static_cast<double>(k) / pieces * (to - from);
    minMm = alongPiece(last, next, before, minMm, detour);
    last = next;
  }
  return std::max(0.0, minMm);
}

MotionClearance::Speeds MotionClearance::speedsAt(const JointVector& q,
                                                  const JointVector& step) const {
  const robot::Cell& cell = collision_.cell();
  Speeds speeds;
  Frames here, there;
  cell.framePoses(q, here);
  for (std::size_t b = 0; b < balls_.size(); ++b) {
    const int frame = b < cell.bodies().size() ? cell.bodies()[b].frame : cell.workFrame();
    speeds.ball.push_back(
        {here[static_cast<std::size_t>(frame)] * balls_[b].centre, balls_[b].radius});
  }
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    if (step[j] == 0.0)
      continue;
    JointVector moved = q;
    moved[j] += kStep;
    cell.framePoses(moved, there);
    std::vector<Twist>& twist = speeds.twist.emplace_back();
    for (std::size_t f = 0; f < here.size(); ++f)
      twist.push_back(twistBetween(here[f], there[f]));
    speeds.step.push_back(std::abs(step[j]));
    if (cell.limits()[static_cast<std::size_t>(j)].kind == robot::JointKind::Turning)
      speeds.angleRad += std::abs(step[j]);
  }
  return speeds;
}

// A joint that moves both bodies alike does not change their distance. While other joints turn, the
// displacement that a joint causes at a point grows per radian by at most the displacement of the
// point.
double MotionClearance::displacementOf(const Contact& pair, const Speeds& speeds) const {
  const robot::Cell& cell = collision_.cell();
  const auto frameOf = [&](int body) {
    return static_cast<std::size_t>(body == kPrintedPart
                                        ? cell.workFrame()
                                        : cell.bodies()[static_cast<std::size_t>(body)].frame);
  };
  const auto ballOf = [&](int body) -> const Ball& {
    return body == kPrintedPart ? speeds.ball.back() : speeds.ball[static_cast<std::size_t>(body)];
  };
  double displacement = 0.0;
  for (std::size_t j = 0; j < speeds.step.size(); ++j) {
    const Twist &first = speeds.twist[j][frameOf(pair.first)],
                &second = speeds.twist[j][frameOf(pair.second)];
    if (!first.isSame(second))
      displacement += speeds.step[j] * (first.upperBound(ballOf(pair.first)) +
                                        second.upperBound(ballOf(pair.second)));
  }
  return displacement / (1.0 - 2.0 * speeds.angleRad);
}

double MotionClearance::alongPiece(const JointVector& from, const JointVector& to,
                                   std::size_t before, double minMm, double detour) const {
  const Speeds speeds = speedsAt(from, to - from);
  Frames start, end;
  collision_.cell().framePoses(from, start);
  collision_.cell().framePoses(to, end);
  for (const Contact& pair : pairs_) {
    const double displacement = detour * displacementOf(pair, speeds);
    if (displacement <= 0.0)
      continue;
    const double fromMm = collision_.distanceOf(pair, start, part_, before, minMm + displacement);
    if (fromMm >= minMm + displacement)
      continue;
    const double toMm = collision_.distanceOf(pair, end, part_, before, minMm + displacement);
    minMm = refined({pair, before, from, to, fromMm, toMm, displacement}, minMm);
  }
  return minMm;
}

double MotionClearance::refined(const Stretch& s, double minMm) const {
  const double lower = 0.5 * (s.fromMm + s.toMm - s.displacementMm) - kDistanceMm;
  if (lower >= minMm)
    return minMm;
  if (s.displacementMm <= 2.0 * (kMotionExactMm - kDistanceMm))
    return lower;
  const JointVector middle = 0.5 * (s.from + s.to);
  Frames frames;
  collision_.cell().framePoses(middle, frames);
  const double half = 0.5 * s.displacementMm;
  const double mm = collision_.distanceOf(s.pair, frames, part_, s.before, minMm + half);
  minMm = refined({s.pair, s.before, s.from, middle, s.fromMm, mm, half}, minMm);
  return refined({s.pair, s.before, middle, s.to, mm, s.toMm, half}, minMm);
}

} // namespace voluta::collision
