#include "window/pages/jogged_arm.h"

#include "base/run_context.h"
#include "base/units.h"
#include "process/process.h"
#include "project/job.h"
#include "robot/cell.h"

#include <algorithm>
#include <cmath>

namespace voluta::window {

using Eigen::Isometry3d, Eigen::Matrix3d, Eigen::Vector3d;

namespace {

// An upright nozzle points down: its z is against the platform's.
const Vector3d kUpright(1.0, -1.0, -1.0);

Matrix3d rotationOf(const Vector3d& anglesDeg) {
  Matrix3d rotation = Matrix3d::Identity();
  for (int axis = 2; axis >= 0; --axis)
    rotation = Eigen::AngleAxisd(base::degreesToRadians(anglesDeg[axis]), Vector3d::Unit(axis))
                   .toRotationMatrix() *
               rotation;
  return rotation;
}

Vector3d anglesOf(const Matrix3d& r) {
  constexpr double kLocked = 1.0 - 1e-12; // y is at 90 degrees: only x and z together are known
  const double sine = std::clamp(r(0, 2), -1.0, 1.0);
  Vector3d angles(std::atan2(-r(1, 2), r(2, 2)), std::asin(sine), std::atan2(-r(0, 1), r(0, 0)));
  if (std::abs(sine) > kLocked)
    angles = Vector3d(std::atan2(r(2, 1), r(1, 1)), std::asin(sine), 0.0);
  return angles.unaryExpr([](double rad) { return base::radiansToDegrees(rad); });
}

} // namespace

NozzlePose nozzlePose(const Isometry3d& work_T_tool) {
  return {work_T_tool.translation(), anglesOf(work_T_tool.linear() * kUpright.asDiagonal())};
}

Isometry3d work_T_toolOf(const NozzlePose& pose) {
  Isometry3d work_T_tool = Isometry3d::Identity();
  work_T_tool.linear() = rotationOf(pose.anglesDeg) * kUpright.asDiagonal();
  work_T_tool.translation() = pose.tipMm;
  return work_T_tool;
}

std::shared_ptr<const collision::GrowingPart> joggingPart(const pipeline::PlanResult& plan,
                                                          const base::RunContext& ctx) {
  constexpr double kCoarser = 2.0;
  const plan::ToolPlan& paths = *plan.job.toolPlan;
  const double pitchMm = kCoarser * collision::growingPitch(paths, plan.tooling());
  return std::make_shared<collision::GrowingPart>(
      paths, pitchMm, ctx,
      collision::groundCells(project::platformOf(plan.job), paths, pitchMm, ctx));
}

JoggedArm::JoggedArm(std::shared_ptr<const pipeline::PlanResult> plan, robot::JointVector joints)
    : plan_(std::move(plan)), joints_(std::move(joints)),
      collision_(std::make_shared<collision::CellCollision>(*plan_->cell,
                                                            plan_->tooling().first().process)) {}

NozzlePose JoggedArm::nozzle() const {
  return nozzlePose(cell().work_T_tool(joints_));
}

void JoggedArm::setJoint(Eigen::Index joint, double value) {
  const robot::JointLimits& limits = cell().limits()[static_cast<std::size_t>(joint)];
  joints_[joint] = std::clamp(value, limits.min, limits.max);
}

bool JoggedArm::setNozzle(const NozzlePose& pose) {
  return moveTo(work_T_toolOf(pose));
}

bool JoggedArm::step(int coordinate, double amount) {
  Isometry3d work_T_tool = cell().work_T_tool(joints_);
  if (coordinate < 3)
    work_T_tool.translation()[coordinate] += amount;
  else
    work_T_tool.linear() =
        Eigen::AngleAxisd(base::degreesToRadians(amount), Vector3d::Unit(coordinate - 3))
            .toRotationMatrix() *
        work_T_tool.linear();
  return moveTo(work_T_tool);
}

bool JoggedArm::moveTo(const Isometry3d& work_T_tool) {
  std::vector<robot::JointVector> solutions;
  cell().inverse(work_T_tool, joints_, solutions);
  const auto nearest = std::ranges::min_element(solutions, {}, [&](const robot::JointVector& q) {
    return robot::largestRotation(q - joints_, cell().limits());
  });
  if (nearest == solutions.end())
    return false;
  joints_ = *nearest;
  return true;
}

void JoggedArm::setPart(std::shared_ptr<const collision::GrowingPart> part, std::size_t before) {
  part_ = std::move(part);
  before_ = before;
}

std::function<JoggedArm::Check()> JoggedArm::check() const {
  return [plan = plan_, joints = joints_, collision = collision_, part = part_, before = before_] {
    const collision::Margins touching{0.0, 0.0, 0.0};
    collision::CellCollision::Frames frames;
    plan->cell->framePoses(joints, frames);
    const auto contact = part ? collision->any(frames, *part, before, touching)
                              : collision->bodies(frames, touching);
    Check check;
    if (contact) {
      check.colliding.emplace(collision->nameOf(contact->first),
                              collision->nameOf(contact->second));
      return check;
    }
    check.clearanceMm = collision->clearance(frames, kMaxClearanceMm);
    if (part)
      check.clearanceMm = std::min(
          check.clearanceMm, collision->clearanceToPart(frames, *part, before, kMaxClearanceMm));
    return check;
  };
}

} // namespace voluta::window
