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
constexpr double kMaxTurnRad = 0.25;
constexpr double kStep = 1e-4;       // rad or mm, of the finite differences
constexpr double kInexact = 1.001;   // error bound of the speeds by finite differences
constexpr double kSameSpeed = 1e-4;  // mm and rad per unit of the joint
constexpr double kDistanceMm = 1e-4; // accuracy of distances

// Motion of a frame per unit of a joint: the speed of its point at the base's origin, and its
// angular velocity.
struct Twist {
  Vector3d speed = Vector3d::Zero(), turn = Vector3d::Zero();

  bool isSame(const Twist& other) const {
    return (speed - other.speed).norm() < kSameSpeed && (turn - other.turn).norm() < kSameSpeed;
  }
  // Upper bound for all points of a sphere.
  double most(const Ball& ball) const {
    return kInexact * ((speed + turn.cross(ball.centre)).norm() + turn.norm() * ball.radius);
  }
};

Twist twistBetween(const Isometry3d& from, const Isometry3d& to) {
  const Isometry3d moved = to * from.inverse(Eigen::Isometry);
  const Eigen::Matrix3d& r = moved.linear();
  return {moved.translation() / kStep,
          Vector3d(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)) / (2.0 * kStep)};
}
} // namespace

struct WayClearance::Stretch {
  const Contact& pair;
  std::size_t before;
  JointVector from, to;
  double fromMm, toMm; // distances, or lower bounds
  double wayMm;        // upper bound of the relative displacement of points of the two
};

struct WayClearance::Speeds {
  std::vector<double> step;              // per moving joint
  double turnRad = 0.0;                  // of all of them
  std::vector<std::vector<Twist>> twist; // per moving joint, per frame
  std::vector<Ball> ball;                // as balls_, in the base
};

WayClearance::WayClearance(const CellCollision& collision, const GrowingPart& part)
    : collision_(collision), part_(part), pairs_(collision.clearancePairs()) {
  for (std::size_t b = 0; b < collision.cell().bodies().size(); ++b)
    balls_.push_back(collision.ballAbout(static_cast<int>(b)));
  const Eigen::AlignedBox3d box = part.bounds();
  balls_.push_back(box.isEmpty() ? Ball{Vector3d::Zero(), 0.0}
                                 : Ball{box.center(), 0.5 * box.diagonal().norm()});
}

double WayClearance::along(const JointVector& from, const JointVector& to, std::size_t before,
                           double leastMm, double detour) const {
  const robot::Cell& cell = collision_.cell();
  double turn = 0.0;
  for (Eigen::Index j = 0; j < from.size(); ++j)
    if (cell.limits()[static_cast<std::size_t>(j)].kind == robot::JointKind::Turning)
      turn += std::abs(to[j] - from[j]);
  const int pieces = std::max(1, static_cast<int>(std::ceil(turn / kMaxTurnRad)));
  JointVector last = from;
  for (int k = 1; k <= pieces; ++k) {
    const JointVector next = from + static_cast<double>(k) / pieces * (to - from);
    leastMm = alongPiece(last, next, before, leastMm, detour);
    last = next;
  }
  return std::max(0.0, leastMm);
}

WayClearance::Speeds WayClearance::speedsAt(const JointVector& q, const JointVector& step) const {
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
      speeds.turnRad += std::abs(step[j]);
  }
  return speeds;
}

// A joint that moves both bodies alike does not change their distance. While other joints turn, the
// displacement that a joint causes at a point grows per radian by at most the displacement of the
// point.
double WayClearance::wayOf(const Contact& pair, const Speeds& speeds) const {
  const robot::Cell& cell = collision_.cell();
  const auto frameOf = [&](int body) {
    return static_cast<std::size_t>(body == kPrintedPart
                                        ? cell.workFrame()
                                        : cell.bodies()[static_cast<std::size_t>(body)].frame);
  };
  const auto ballOf = [&](int body) -> const Ball& {
    return body == kPrintedPart ? speeds.ball.back() : speeds.ball[static_cast<std::size_t>(body)];
  };
  double way = 0.0;
  for (std::size_t j = 0; j < speeds.step.size(); ++j) {
    const Twist &first = speeds.twist[j][frameOf(pair.first)],
                &second = speeds.twist[j][frameOf(pair.second)];
    if (!first.isSame(second))
      way += speeds.step[j] * (first.most(ballOf(pair.first)) + second.most(ballOf(pair.second)));
  }
  return way / (1.0 - 2.0 * speeds.turnRad);
}

double WayClearance::alongPiece(const JointVector& from, const JointVector& to, std::size_t before,
                                double leastMm, double detour) const {
  const Speeds speeds = speedsAt(from, to - from);
  Frames start, end;
  collision_.cell().framePoses(from, start);
  collision_.cell().framePoses(to, end);
  for (const Contact& pair : pairs_) {
    const double way = detour * wayOf(pair, speeds);
    if (way <= 0.0)
      continue;
    const double fromMm = collision_.distanceOf(pair, start, part_, before, leastMm + way);
    if (fromMm >= leastMm + way)
      continue;
    const double toMm = collision_.distanceOf(pair, end, part_, before, leastMm + way);
    leastMm = refined({pair, before, from, to, fromMm, toMm, way}, leastMm);
  }
  return leastMm;
}

double WayClearance::refined(const Stretch& s, double leastMm) const {
  const double lower = 0.5 * (s.fromMm + s.toMm - s.wayMm) - kDistanceMm;
  if (lower >= leastMm)
    return leastMm;
  if (s.wayMm <= 2.0 * (kWayExactMm - kDistanceMm))
    return lower;
  const JointVector middle = 0.5 * (s.from + s.to);
  Frames frames;
  collision_.cell().framePoses(middle, frames);
  const double half = 0.5 * s.wayMm;
  const double mm = collision_.distanceOf(s.pair, frames, part_, s.before, leastMm + half);
  leastMm = refined({s.pair, s.before, s.from, middle, s.fromMm, mm, half}, leastMm);
  return refined({s.pair, s.before, middle, s.to, mm, s.toMm, half}, leastMm);
}

} // namespace voluta::collision
