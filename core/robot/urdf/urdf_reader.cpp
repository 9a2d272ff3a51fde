#include "robot/urdf/urdf_reader.h"

#include "base/error.h"
#include "base/units.h"
#include "robot/kinematics/chain_kinematics.h"
#include "robot/urdf/urdf_chain.h"
#include "robot/urdf/urdf_shapes.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

namespace voluta::robot {

namespace {

constexpr double kAccelerationDegPerS2 = 800.0, kVelocityDegPerS = 180.0, kRevolutionDeg = 360.0;

std::string idOf(const std::string& name) {
  std::string id;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)))
      id += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!id.empty() && id.back() != '-')
      id += '-';
  while (!id.empty() && id.back() == '-')
    id.pop_back();
  return id.empty() ? "robot" : id;
}

// Moves the limits to those of the joint's safety controller where these are tighter.
void tighten(JointLimits& limits, const UrdfJoint& joint, const std::string& where,
             std::vector<std::string>& assumed) {
  if (!joint.softLimit)
    return;
  const double min = std::max(limits.min, joint.softLimit->lower);
  const double max = std::min(limits.max, joint.softLimit->upper);
  if (!(min < max))
    throw base::Error(
        base::ErrorCode::UnusableInput,
        base::message("joint '{joint}': the limits of its safety controller leave no room"_text,
                      joint.name),
        where);
  if (min > limits.min || max < limits.max)
    assumed.push_back(fmt::format("joint '{}' turns from {:.4g} to {:.4g} deg, as its safety "
                                  "controller limits it",
                                  joint.name, base::radiansToDegrees(min),
                                  base::radiansToDegrees(max)));
  limits.min = min;
  limits.max = max;
}

JointLimits limitsOf(const UrdfJoint& joint, const std::string& where,
                     std::vector<std::string>& assumed) {
  const auto radians = [](double degrees) { return base::degreesToRadians(degrees); };
  JointLimits limits{-radians(kRevolutionDeg), radians(kRevolutionDeg), radians(kVelocityDegPerS),
                     radians(kAccelerationDegPerS2)};
  // Values of many turns, or faster than any joint, are placeholders, or in degrees.
  constexpr double kMaxRad = 8.0 * base::kPi, kMaxRadPerS = 100.0;
  UrdfLimit given = joint.limit.value_or(UrdfLimit{});
  const bool isFar = !(std::abs(given.lower) < kMaxRad && std::abs(given.upper) < kMaxRad);
  if (!(given.velocity < kMaxRadPerS))
    given.velocity = 0.0;
  const bool none = given.lower == 0.0 && given.upper == 0.0;
  if (joint.type == "revolute" && isFar) {
    assumed.push_back(fmt::format("joint '{}' turns +-{} deg: the description's limits, {:g} and "
                                  "{:g} rad, are more than four turns (limits are in radians, not "
                                  "in degrees)",
                                  joint.name, kRevolutionDeg, given.lower, given.upper));
  } else if (joint.type == "revolute" && !none) {
    if (!(given.lower < given.upper))
      throw base::Error(
          base::ErrorCode::UnusableInput,
          base::message("joint '{joint}': the lower limit is not below the upper one"_text,
                        joint.name),
          where);
    limits.min = given.lower;
    limits.max = given.upper;
  } else if (joint.type == "revolute") {
    assumed.push_back(fmt::format("joint '{}' turns +-{} deg: the description has {} limits",
                                  joint.name, kRevolutionDeg, joint.limit ? "zero" : "no"));
  } else {
    assumed.push_back(fmt::format("joint '{}', which turns without end, is kept within +-{} deg",
                                  joint.name, kRevolutionDeg));
  }
  tighten(limits, joint, where, assumed);
  if (given.velocity > 0.0)
    limits.velocity = given.velocity;
  else
    assumed.push_back(
        fmt::format("joint '{}' turns at {} deg/s: the description has no usable velocity",
                    joint.name, kVelocityDegPerS));
  return limits;
}

} // namespace

UrdfRobot readUrdf(const std::filesystem::path& file, const UrdfOptions& options) {
  const std::string where = file.filename().string();
  const UrdfTree tree = readUrdfTree(file);
  UrdfChain found = urdfChain(tree, options.tip, options.base, where);
  UrdfRobot robot;
  RobotModel& model = robot.model;
  model.id = options.id.empty() ? idOf(tree.name) : options.id;
  model.label = tree.name.empty() ? model.id : tree.name;
  model.maker = "unknown";
  model.controller = options.controller;
  std::vector<std::string>& assumed = model.assumed;
  assumed.push_back(fmt::format("poses are counted from the frame of link '{}', the flange is the "
                                "frame of link '{}', its z out of it: as the description is taken",
                                found.base, found.tip));
  for (const std::size_t j : found.joints)
    model.limits.push_back(limitsOf(tree.joints[j], where, assumed));
  assumed.push_back(fmt::format("joint accelerations of {} deg/s2: URDF files do not state them",
                                kAccelerationDegPerS2));
  for (const std::string& joint : found.leftOut)
    assumed.push_back(fmt::format("the branch moved by joint '{}' is left out", joint));
  model.links = urdfBodies(tree, found, file, assumed);
  model.kinematics = std::make_shared<ChainKinematics>(found.chain);
  assumed.push_back("nominal lengths: a real arm has its own calibration");
  robot.base = found.base;
  robot.tip = found.tip;
  robot.chain = std::move(found.chain);
  robot.source = "imported from " + where;
  return robot;
}

} // namespace voluta::robot
