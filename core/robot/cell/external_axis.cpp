#include "robot/cell/external_axis.h"

#include "base/units.h"
#include "robot/cell/json_pose.h"
#include "robot/cell/limits_reader.h"
#include "robot/cell/shape_reader.h"
#include "robot/shape/shape_moves.h"

namespace voluta::robot {

using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

// Returns a rotation that maps x to the unit direction; for a frame axis, in either sense, the one
// that permutes the axes cyclically.
Isometry3d xTo(const Vector3d& direction) {
  constexpr double kSame = 1e-12;
  Isometry3d rotation = Isometry3d::Identity();
  for (int k = 0; k < 3; ++k)
    for (const double sign : {1.0, -1.0})
      if ((direction - sign * Vector3d::Unit(k)).norm() < kSame) {
        rotation.linear() << sign * Vector3d::Unit(k), sign * Vector3d::Unit((k + 1) % 3),
            Vector3d::Unit((k + 2) % 3);
        return rotation;
      }
  rotation.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), direction).toRotationMatrix();
  return rotation;
}

JointKind readKind(const base::JsonNode& node) {
  const std::string kind = node.text();
  if (kind == "turning")
    return JointKind::Turning;
  if (kind == "sliding")
    return JointKind::Sliding;
  node.fail(base::message("must be turning or sliding, is '{kind}'"_text, kind));
}

} // namespace

Isometry3d movedBy(const ExternalAxis& axis, double value) {
  Isometry3d moved = Isometry3d::Identity();
  if (axis.limits.kind == JointKind::Turning)
    moved.linear() = Eigen::AngleAxisd(value, Vector3d::UnitX()).toRotationMatrix();
  else
    moved.translation().x() = value;
  return moved;
}

AxisDescription readExternalAxis(const base::JsonNode& node, const ExternalAxis* before) {
  AxisDescription described;
  ExternalAxis& axis = described.axis;
  const JointKind kind = readKind(node.at("kind"));
  if (kind == JointKind::Turning)
    node.allowOnly({"name", "kind", "carries", "pose", "axis", "minDeg", "maxDeg",
                    "velocityDegPerS", "accelerationDegPerS2", "stepDeg", "end", "bodies"});
  else
    node.allowOnly({"name", "kind", "carries", "pose", "axis", "minMm", "maxMm", "velocityMmPerS",
                    "accelerationMmPerS2", "stepMm", "bodies"});
  axis.name = node.at("name").text();
  const std::string carries = node.has("carries") ? node.at("carries").text() : "platform";
  if (carries != "platform" && carries != "robot")
    node.at("carries").fail(
        base::message("must be platform or robot, is '{carries}'"_text, carries));
  axis.carriesRobot = carries == "robot";
  if (axis.carriesRobot && before != nullptr && !before->carriesRobot)
    node.at("carries").fail("must be platform after an axis that carries the platform"_text);
  axis.limits = readJointLimits(node, kind);
  if (kind == JointKind::Turning) {
    axis.step = base::degreesToRadians(node.at("stepDeg").notNegative());
    const std::string end = node.at("end").text();
    if (end != "unwinds" && end != "runsOn")
      node.at("end").fail(base::message("must be unwinds or runsOn, is '{end}'"_text, end));
    axis.runsOn = end == "runsOn";
  } else {
    axis.step = node.at("stepMm").notNegative();
  }
  if (axis.limits.min > 0.0 || axis.limits.max < 0.0)
    node.fail("must include the home position 0 in its limits"_text);

  const Vector3d direction = readVector3(node.at("axis"));
  if (direction.norm() < 1e-6)
    node.at("axis").fail("must not be zero"_text);
  // Seen from the base, the world moves the opposite way of an axis that carries the robot.
  const Isometry3d rotation = xTo((axis.carriesRobot ? -1.0 : 1.0) * direction.normalized());
  const Isometry3d pose = readPose(node.at("pose"));
  axis.before_T_axis = pose * rotation;
  axis.axis_T_moved = (axis.carriesRobot ? axis.before_T_axis : rotation).inverse(Eigen::Isometry);
  if (before != nullptr)
    axis.before_T_axis = before->axis_T_moved * axis.before_T_axis;
  if (node.has("bodies"))
    for (const base::JsonNode& body : node.at("bodies").items()) {
      body.allowOnly({"name", "shapes"});
      std::vector<Shape> shapes = readShapes(body.at("shapes"));
      if (axis.carriesRobot)
        for (Shape& shape : shapes)
          shape = moved(std::move(shape), pose);
      described.bodies.push_back(
          {body.at("name").text(), BodyRole::Obstacle, 0, std::move(shapes)});
    }
  return described;
}

} // namespace voluta::robot
