#include "motion/motion_scene.h"

#include "motion/nozzle_frame.h"
#include "motion/rod_turn.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using robot::JointVector;

namespace {
constexpr double kLeverMm = robot::kSlideMmPerRad; // of an arm's joint: a small one, to be careful
} // namespace

double MotionScene::bend(const Vector3d& from, const Vector3d& to, double angle) const {
  if (cell.nozzleMount() == robot::Mount::Flange)
    return 0.0; // the tool centre is the tip itself
  const double lever = std::max(from.norm(), to.norm());
  return lever * angle * angle / 8.0 + (to - from).norm() * angle / 4.0;
}

int MotionScene::divisions(const Vector3d& from, const Vector3d& to, double angle) const {
  const double bends = bend(from, to, angle);
  if (bends <= options.deviationMm)
    return 1;
  return static_cast<int>(std::ceil(std::sqrt(bends / options.deviationMm)));
}

double MotionScene::span(const JointVector& a, const JointVector& b) const {
  const double arm = robot::largestTurn(b - a, cell.robot().limits);
  const double rod = std::abs(rodAngle(cell, b) - rodAngle(cell, a));
  return std::max(arm, rod * partRadiusMm / kLeverMm);
}

bool solveNear(const robot::Cell& cell, const Vector3d& tip, const Quaterniond& tool,
               const JointVector& near, double maxStep, std::vector<JointVector>& scratch,
               JointVector& q) {
  cell.inverse(toolPose(tip, tool), near, scratch);
  double best = maxStep;
  bool found = false;
  for (const JointVector& s : scratch) {
    const double step = robot::largestTurn(s - near, cell.robot().limits);
    if (step <= best) {
      best = step;
      q = s;
      found = true;
    }
  }
  return found;
}

double radiusAboutRod(const plan::ToolPlan& plan) {
  double radius = 0.0;
  for (const Eigen::Vector3d& p : plan.position)
    radius = std::max(radius, p.tail<2>().norm());
  return radius;
}

} // namespace voluta::motion
