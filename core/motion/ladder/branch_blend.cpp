#include "motion/ladder/branch_blend.h"

#include "base/units.h"
#include "collision/cell_collision.h"
#include "geometry/least_squares.h"
#include "motion/motion_options.h"
#include "motion/nozzle_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::motion {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr std::array<std::size_t, 6> kHalves{3, 6, 12, 24, 48, 96}; // points on both sides
// The stretched pose itself must be neither a point nor a sixteenth of the way to one
// (movesStraight), which has no unique joints.
constexpr std::array<double, 3> kSkews{1.13, 0.91, 1.31};
constexpr double kTurnsRad = 0.8; // joints that change further turn first
constexpr double kFlipRad = 0.5;  // largest change of the arm's joints before the wrist
constexpr Eigen::Index kWrist = 3;
constexpr double kSlow = 0.5; // share of the speed limits
constexpr double kThereMm = 1e-6, kMeetMm = 1e-3, kHeadMm = 0.05;
constexpr double kStepRad = 1e-6;   // of differences
constexpr double kMmPerRad = 300.0; // directions as lengths where both are compared
constexpr int kNewtonSteps = 30;
constexpr double kDivideRad = 0.1; // largest step of a joint between two points
constexpr double kInside = 0.98;   // of the cone, for directions pulled back into it

double smoothStep(double s) {
  return s * s * (3.0 - 2.0 * s);
}

class Blend {
public:
  Blend(const MotionScene& scene, const Run& before, const Run& after, double coneRad)
      : scene_(scene), before_(before), after_(after), coneRad_(coneRad),
        change_(after.points.front().at.q - before.points.back().at.q) {
    shift_ = JointVector::Zero(change_.size());
    for (Eigen::Index j = 0; j < scene.cell.armDof(); ++j)
      shiftTurns(j);
    change_ += shift_;
  }

  bool armFlips() const {
    return change_.head(std::min<Eigen::Index>(kWrist, scene_.cell.armDof()))
               .cwiseAbs()
               .maxCoeff() > kFlipRad;
  }

  // Joins the runs over `half` points on both sides of where they meet. `skew`: exponent of the way
  // behind it.
  BlendedRun over(std::size_t half, double skew) const {
    BlendedRun blended;
    const std::size_t last = before_.points.size() - 1;
    const std::size_t from = last - std::min(half, last),
                      to = std::min(half, after_.points.size() - 1);
    Run run;
    run.path = before_.path;
    run.points.assign(before_.points.begin(),
                      before_.points.begin() + static_cast<std::ptrdiff_t>(from) + 1);
    for (std::size_t i = from + 1; i <= last; ++i)
      if (!append(before_.points[i - 1], before_.points[i], turning(i, from, last), run.points,
                  blended))
        return blended;
    for (std::size_t i = 1; i <= to; ++i)
      if (!append(after_.points[i - 1], shifted(after_.points[i]), passing(i, to, skew), run.points,
                  blended))
        return blended;
    blended.points = run.points.size() - from;
    for (std::size_t i = to + 1; i < after_.points.size(); ++i)
      run.points.push_back(shifted(after_.points[i]));
    for (const RunPoint& p : run.points)
      run.ladder.push_back(p.at.q);
    blended.run = std::move(run);
    return blended;
  }

private:
  // Chooses the whole turns of the second run with which a joint changes least.
  void shiftTurns(Eigen::Index j) {
    const robot::JointLimits& l = scene_.cell.robot().limits[static_cast<std::size_t>(j)];
    if (l.kind != robot::JointKind::Turning)
      return;
    const double by = -base::kTwoPi * std::round(change_[j] / base::kTwoPi);
    for (const RunPoint& p : after_.points)
      if (p.at.q[j] + by < l.min || p.at.q[j] + by > l.max)
        return;
    shift_[j] = by;
  }

  RunPoint shifted(RunPoint point) const {
    point.at.q += shift_;
    return point;
  }

  bool turnsFirst(Eigen::Index j) const { return std::abs(change_[j]) > kTurnsRad; }

  // Returns joints near those wanted at a point of the first run: the far joints turn.
  JointVector turning(std::size_t i, std::size_t from, std::size_t last) const {
    JointVector q = before_.points[i].at.q;
    const double share =
        smoothStep(static_cast<double>(i - from) / static_cast<double>(last - from));
    for (Eigen::Index j = 0; j < q.size(); ++j)
      if (turnsFirst(j))
        q[j] += share * change_[j];
    return q;
  }

  // And of the second run: the other joints come.
  JointVector passing(std::size_t i, std::size_t to, double skew) const {
    JointVector q = after_.points[i].at.q + shift_;
    const double left =
        1.0 - smoothStep(std::pow(static_cast<double>(i) / static_cast<double>(to), skew));
    for (Eigen::Index j = 0; j < q.size(); ++j)
      if (!turnsFirst(j))
        q[j] -= left * change_[j];
    return q;
  }

  // Moves the joints to the nearest ones with the tip there and the direction in the cone. Returns
  // false if there are none nearby.
  bool project(const Vector3d& tip, const Vector3d& direction, JointVector& q) const {
    const Eigen::Index dof = scene_.cell.armDof();
    const auto missing = [&](const JointVector& at) {
      const Isometry3d pose = scene_.cell.work_T_tool(at);
      Eigen::Matrix<double, 6, 1> left = Eigen::Matrix<double, 6, 1>::Zero();
      left.head<3>() = tip - pose.translation();
      const Vector3d own = -pose.linear().col(2);
      const double angle = std::acos(std::clamp(own.dot(direction), -1.0, 1.0));
      if (angle > coneRad_) {
        const Vector3d axis = own.cross(direction).normalized();
        left.tail<3>() =
            kMmPerRad * (Eigen::AngleAxisd(angle - kInside * coneRad_, axis) * own - own);
      }
      return left;
    };
    for (int step = 0; step < kNewtonSteps; ++step) {
      const Eigen::Matrix<double, 6, 1> left = missing(q);
      if (left.head<3>().norm() < kThereMm && left.tail<3>().isZero(0.0))
        return true;
      const bool directed = !left.tail<3>().isZero(0.0);
      const Isometry3d at = scene_.cell.work_T_tool(q);
      Eigen::MatrixXd rates = Eigen::MatrixXd::Zero(directed ? 6 : 3, dof);
      for (Eigen::Index j = 0; j < dof; ++j) {
        JointVector beside = q;
        beside[j] += kStepRad;
        const Isometry3d pose = scene_.cell.work_T_tool(beside);
        rates.col(j).head<3>() = (pose.translation() - at.translation()) / kStepRad;
        if (directed)
          rates.col(j).tail<3>() =
              kMmPerRad * (at.linear().col(2) - pose.linear().col(2)) / kStepRad;
      }
      q.head(dof) += geometry::shortestLeastSquares(rates, left.head(rates.rows()));
    }
    return false;
  }

  // Appends the point with joints near `near`, divided where joints step far. `own`: the point
  // before it, as it was.
  bool append(const RunPoint& own, const RunPoint& to, const JointVector& near,
              std::vector<RunPoint>& points, BlendedRun& blended) const {
    const RunPoint from = points.back();
    JointVector end = near;
    if (!project(to.at.tip, to.at.direction(), end))
      return refused(BlendRefusal::Tilts, blended);
    const int n =
        std::max(1, static_cast<int>(std::ceil(scene_.span(from.at.q, end) / kDivideRad)));
    const Vector3d planned = own.at.direction();
    for (int k = 1; k <= n; ++k) {
      const double t = static_cast<double>(k) / n;
      RunPoint p = to;
      p.volumeMm3 /= n;
      JointVector q = k == n ? end : JointVector(from.at.q + t * (end - from.at.q));
      if (k < n) {
        p.waypoint = plan::kNoWaypoint;
        p.at.tip = from.at.tip + t * (to.at.tip - from.at.tip);
        if (!project(p.at.tip, ((1.0 - t) * planned + t * to.at.direction()).normalized(), q))
          return refused(BlendRefusal::Tilts, blended);
      }
      p.at.q = q;
      // Exactly that of the joints: near a stretched wrist they depend on every micrometre.
      const Isometry3d pose = scene_.cell.work_T_tool(q);
      p.at.tip = pose.translation();
      p.at.tool = Eigen::Quaterniond(pose.linear());
      if (!isSound(points.back(), p, blended))
        return false;
      points.push_back(std::move(p));
    }
    return true;
  }

  bool isSound(const RunPoint& from, const RunPoint& to, BlendedRun& blended) const {
    const std::vector<robot::JointLimits>& limits = scene_.cell.robot().limits;
    const double distance = (to.at.tip - from.at.tip).norm();
    for (Eigen::Index j = 0; j < scene_.cell.armDof(); ++j) {
      const robot::JointLimits& l = limits[static_cast<std::size_t>(j)];
      if (to.at.q[j] < l.min || to.at.q[j] > l.max)
        return refused(BlendRefusal::Limits, blended);
      if (distance > 0.0)
        blended.speedShare =
            std::max(blended.speedShare,
                     std::abs(to.at.q[j] - from.at.q[j]) * to.speedMmPerS / distance / l.velocity);
    }
    const Isometry3d tool = toolPose(to.at.tip, to.at.tool);
    collision::CellCollision::Frames frames;
    scene_.cell.framePoses(to.at.q, frames);
    if (scene_.collision.bodies(frames, scene_.options.printing) ||
        scene_.collision.bodiesAndPart(frames, scene_.part, to.next, scene_.options.printing) ||
        scene_.collision.headTouchesPart(tool, scene_.part, to.next, kHeadMm) ||
        scene_.collision.headTouchesPlatform(tool, kHeadMm))
      return refused(BlendRefusal::Collides, blended);
    const double angle = angleBetween(from.at.tool, to.at.tool);
    if (scene_.bend(from.at.tip, to.at.tip, angle) > scene_.options.deviationMm ||
        !scene_.movesStraight(from.at, to.at))
      return refused(BlendRefusal::Jumps, blended);
    return true;
  }

  static bool refused(BlendRefusal why, BlendedRun& blended) {
    blended.why = why;
    return false;
  }

  const MotionScene& scene_;
  const Run &before_, &after_;
  double coneRad_;
  JointVector change_, shift_; // of joints from the first run's branch to the second's; whole turns
};

} // namespace

BlendedRun blendBranches(const MotionScene& scene, const Run& before, const Run& after,
                         double coneRad) {
  BlendedRun best;
  if (before.points.size() < 2 || after.points.size() < 2 || !scene.cell.externalAxes().empty() ||
      (before.points.back().at.tip - after.points.front().at.tip).norm() > kMeetMm) {
    best.why = BlendRefusal::Apart;
    return best;
  }
  const Blend blend(scene, before, after, coneRad);
  if (blend.armFlips()) {
    best.why = BlendRefusal::ArmFlips;
    return best;
  }
  for (const std::size_t half : kHalves)
    for (const double skew : kSkews) {
      BlendedRun blended = blend.over(half, skew);
      if (blended.run ? !best.run || blended.speedShare < best.speedShare : !best.run)
        best = std::move(blended);
      if (best.run && best.speedShare <= kSlow)
        return best;
    }
  return best;
}

} // namespace voluta::motion
