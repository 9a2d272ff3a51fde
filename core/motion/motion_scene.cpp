#include "motion/motion_scene.h"

#include "collision/shape_distance.h"
#include "motion/motion_options.h"
#include "motion/nozzle_frame.h"
#include "plan/tool_plan.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using robot::JointVector;

namespace {
// Lever of an arm's joint: a small, conservative value
constexpr double kLeverMm = robot::kSlideMmPerRad;
} // namespace

double MotionScene::bend(const Vector3d& from, const Vector3d& to, double angle) const {
  if (cell.nozzleMount() == robot::Mount::Flange)
    return 0.0; // The tool centre is the tip itself
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
  const double arm = robot::largestRotation(b - a, cell.robot().limits);
  double axes = 0.0;
  for (std::size_t k = 0; k < leversMm.size(); ++k) {
    const Eigen::Index j = cell.armDof() + static_cast<Eigen::Index>(k);
    axes += std::abs(b[j] - a[j]) * leversMm[k] / kLeverMm;
  }
  return std::max(arm, axes);
}

int MotionScene::sideOf(const JointVector& q) const {
  std::vector<Eigen::Isometry3d> links;
  return twists.singularSide(q, links);
}

bool MotionScene::movesStraight(const RobotState& from, const RobotState& to) const {
  if (sideOf(from.q) * sideOf(to.q) >= 0)
    return true;
  constexpr int kSteps = 16;
  constexpr double kThere = 1e-4; // [rad]
  std::vector<JointVector> scratch;
  JointVector q = from.q;
  double travelled = 0.0; // Sum over the steps of the largest joint step
  for (int k = 1; k <= kSteps; ++k) {
    const double t = static_cast<double>(k) / kSteps;
    JointVector last = q;
    const Eigen::Index axes = q.size() - cell.armDof();
    last.tail(axes) = from.q.tail(axes) + t * (to.q.tail(axes) - from.q.tail(axes));
    if (!solveNear(cell, from.tip + t * (to.tip - from.tip), from.tool.slerp(t, to.tool), last,
                   options.maxStepRad, scratch, q))
      return false;
    travelled += robot::largestRotation(q - last, cell.robot().limits);
  }
  return travelled <= options.maxStepRad &&
         robot::largestRotation(q - to.q, cell.robot().limits) <= kThere;
}

bool solveNear(const robot::Cell& cell, const Vector3d& tip, const Quaterniond& tool,
               const JointVector& near, double maxStep, std::vector<JointVector>& scratch,
               JointVector& q) {
  const Eigen::Isometry3d pose = toolPose(tip, tool);
  if (const auto next = cell.next(pose, near, maxStep)) {
    q = *next;
    return true;
  }
  cell.inverse(pose, near, scratch);
  double best = maxStep;
  bool found = false;
  for (const JointVector& s : scratch) {
    const double step = robot::largestRotation(s - near, cell.robot().limits);
    if (step <= best) {
      best = step;
      q = s;
      found = true;
    }
  }
  return found;
}

std::vector<double> leversOf(const plan::ToolPlan& plan, const robot::Cell& cell) {
  const std::size_t count = cell.externalAxes().size();
  std::vector<double> levers(count, 1.0);
  if (cell.rod()) { // The rod and its holder are rotationally symmetric
    double radius = 0.0;
    for (const Vector3d& p : plan.position)
      radius = std::max(radius, p.tail<2>().norm());
    return {radius};
  }
  const auto bodiesReach = [&](int frame) { // Measured from the frame's origin
    double reach = 0.0;
    for (const robot::Body& body : cell.bodies())
      if (body.frame == frame)
        for (const robot::Shape& shape : body.shapes) {
          const collision::Ball ball =
              collision::boundingBall(collision::place(shape, Eigen::Isometry3d::Identity()));
          reach = std::max(reach, ball.centre.norm() + ball.radius);
        }
    return reach;
  };
  double reach = bodiesReach(cell.workFrame());
  for (const Vector3d& p : plan.position)
    reach = std::max(reach, p.norm());
  reach += count > 0 ? cell.axis_T_work().translation().norm() : 0.0;
  for (std::size_t k = count; k-- > 0;) {
    const robot::ExternalAxis& axis = cell.externalAxes()[k];
    reach = std::max(reach, bodiesReach(cell.axisFrame(k)));
    if (axis.limits.kind == robot::JointKind::Turning)
      levers[k] = reach;
    else
      reach += std::max(std::abs(axis.limits.min), std::abs(axis.limits.max));
    reach += axis.before_T_axis.translation().norm();
  }
  return levers;
}

} // namespace voluta::motion
