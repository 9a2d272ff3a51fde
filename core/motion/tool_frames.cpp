#include "motion/tool_frames.h"

#include "geometry/least_turn.h"
#include "motion/external_axes.h"
#include "motion/nozzle_frame.h"

#include <algorithm>

namespace voluta::motion {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr double kOpen = 1e-6; // a hint whose share across the direction is smaller determines no x

// Returns the frame with z against the direction and x as close to `hint` as possible; `last`
// carried along if the hint does not determine x.
Quaterniond towards(const Vector3d& hint, const Vector3d& direction, const Quaterniond& last) {
  const Vector3d z = -direction.normalized();
  const Vector3d x = hint - hint.dot(z) * z;
  if (!(x.norm() > kOpen * hint.norm()) || !(hint.norm() > 0.0))
    return carried(last, direction);
  Eigen::Matrix3d frame;
  frame.col(0) = x.normalized();
  frame.col(2) = z;
  frame.col(1) = z.cross(frame.col(0));
  return Quaterniond(frame);
}

} // namespace

std::vector<Quaterniond> toolFrames(NozzleRotation rule, const plan::ToolPlan& plan,
                                    const robot::Cell& cell, std::size_t first, std::size_t count,
                                    const std::vector<JointVector>& axes, const Quaterniond& from,
                                    const JointVector& fromAxes) {
  const bool moves = !cell.externalAxes().empty();
  if (moves)
    count = std::min(count, axes.size());
  const auto rotationAt = [&](std::size_t i) {
    return moves ? axesRotation(cell, axes[i]) : Quaterniond::Identity();
  };
  const auto rest = [&] {
    return moves ? axesRotation(cell, JointVector::Zero(fromAxes.size())) : Quaterniond::Identity();
  };
  const auto pointAt = [&](std::size_t i) -> Vector3d {
    return moves ? movedByAxes(cell, plan.position[first + i], axes[i]) : plan.position[first + i];
  };
  const Vector3d workX = rest() * Vector3d::UnitX();
  const Quaterniond upright = rest() * uprightTool();
  Quaterniond tool = moves ? axesRotation(cell, fromAxes) * from : from;
  std::vector<Quaterniond> tools(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Quaterniond rotation = rotationAt(i);
    const Vector3d direction = rotation * plan.direction[first + i];
    switch (rule) {
    case NozzleRotation::Free:
      tool = carried(tool, direction);
      break;
    case NozzleRotation::Tangent:
      tool = towards(pointAt(std::min(i + 1, count - 1)) - pointAt(i > 0 ? i - 1 : 0), direction,
                     tool);
      break;
    case NozzleRotation::WorkAxis:
      tool = towards(workX, direction, tool);
      break;
    case NozzleRotation::Rodrigues:
      tool = carried(upright, direction);
      break;
    }
    tools[i] = rotation.conjugate() * tool;
  }
  return tools;
}

} // namespace voluta::motion
