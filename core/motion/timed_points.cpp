#include "motion/timed_points.h"

#include "base/units.h"
#include "motion/motion_scene.h"
#include "process/process.h"

#include <cmath>

namespace voluta::motion {

namespace {

// The steps of an external axis are no accelerations: the motor smooths them to a continuous
// motion.
robot::JointVector withoutSteps(const RobotState& state) {
  robot::JointVector q = state.q;
  q.tail(state.axes.size()) = state.axes;
  return q;
}

// Returns TimedPoint::peakDisplacement for a straight move: the fastest motion of each joint
// between two states, which near a wrist singularity is much faster than the mean. Empty if there
// is no continuous IK solution.
robot::JointVector peakDisplacementBetween(const robot::Cell& cell, const RobotState& from,
                                           const RobotState& to) {
  constexpr int kSteps = 8;
  std::vector<robot::JointVector> scratch;
  robot::JointVector q = from.q, peakDisplacement = robot::JointVector::Zero(q.size());
  for (int k = 1; k <= kSteps; ++k) {
    const double t = static_cast<double>(k) / kSteps;
    robot::JointVector last = q;
    last.tail(to.axes.size()) = from.axes + t * (to.axes - from.axes);
    if (!solveNear(cell, from.tip + t * (to.tip - from.tip), from.tool.slerp(t, to.tool), last,
                   base::kPi, scratch, q))
      return {};
    peakDisplacement = peakDisplacement.cwiseMax((q - last).cwiseAbs());
  }
  return kSteps * peakDisplacement;
}

} // namespace

TimingLimits timingLimits(const robot::Cell& cell, const process::Process& process) {
  TimingLimits limits;
  limits.joints = cell.limits();
  limits.accelerationMmPerS2 = process.accelerationMmPerS2;
  limits.travelRadPerS2 = cell.travelAcceleration();
  limits.arm = cell.armDof();
  return limits;
}

std::vector<robot::JointVector> jointsOf(const std::vector<RunPoint>& points) {
  std::vector<robot::JointVector> joints;
  joints.reserve(points.size());
  for (const RunPoint& p : points)
    joints.push_back(withoutSteps(p.at));
  return joints;
}

std::vector<TimedPoint> timedPoints(const robot::Cell& cell, const std::vector<RunPoint>& points) {
  constexpr double kCloserLook = 0.3; // share of a joint's velocity limit, from point to point
  const auto isFast = [&](const RunPoint& from, const RunPoint& to) {
    const double distance = (to.at.tip - from.at.tip).norm();
    if (to.speedMmPerS <= 0.0 || cell.rod())
      return false; // with a rod the arm hardly moves
    for (Eigen::Index j = 0; j < to.at.q.size(); ++j)
      if (std::abs(to.at.q[j] - from.at.q[j]) * to.speedMmPerS >
          kCloserLook * distance * cell.limits()[static_cast<std::size_t>(j)].velocity)
        return true;
    return false;
  };
  std::vector<TimedPoint> timed;
  timed.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RunPoint& p = points[i];
    timed.push_back({withoutSteps(p.at), p.at.tip, p.speedMmPerS, false, false});
    if (i > 0 && isFast(points[i - 1], p))
      timed.back().peakDisplacement = peakDisplacementBetween(cell, points[i - 1].at, p.at);
  }
  return timed;
}

std::vector<TimedPoint> timedPoints(const RobotState& from, const Transfer& transfer,
                                    double speedMmPerS) {
  std::vector<TimedPoint> timed{{from.q, from.tip, speedMmPerS, false, true}};
  plan::MoveKind last = plan::MoveKind::Linear;
  for (const TransferPoint& p : transfer.points) {
    const bool joint = p.move == plan::MoveKind::Joint;
    if (timed.size() > 1 && p.move != last)
      timed.back().stop = true;
    last = p.move;
    timed.push_back({p.at.q, p.at.tip, speedMmPerS, joint, false, p.peakDisplacement});
  }
  return timed;
}

} // namespace voluta::motion
