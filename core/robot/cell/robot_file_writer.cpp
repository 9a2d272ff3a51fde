#include "robot/cell/robot_file_writer.h"

#include "robot/cell/json_output.h"

#include <nlohmann/json.hpp>

namespace voluta::robot {

namespace {

using Json = nlohmann::ordered_json;
} // namespace

std::string robotFileJson(const RobotModel& robot, const SerialChain& chain,
                          const std::string& source) {
  Json joints = Json::array(), limits = Json::array(), links = Json::array(), never = Json::array();
  for (const ChainJoint& joint : chain.joints)
    joints.push_back({{"pose", poseJson(joint.link_T_joint)}, {"axis", vectorJson(joint.axis)}});
  for (const JointLimits& limit : robot.limits)
    limits.push_back({{"minDeg", degreesJson(limit.min)},
                      {"maxDeg", degreesJson(limit.max)},
                      {"velocityDegPerS", degreesJson(limit.velocity)},
                      {"accelerationDegPerS2", degreesJson(limit.acceleration)}});
  for (const Body& link : robot.links)
    links.push_back(
        {{"name", link.name}, {"frame", link.frame}, {"shapes", shapesJson(link.shapes)}});
  for (const auto& [a, b] : robot.neverMeet)
    never.push_back({{"pair",
                      {robot.links[static_cast<std::size_t>(a)].name,
                       robot.links[static_cast<std::size_t>(b)].name}},
                     {"why", "near each other at most poses that the limits allow, or at rest: "
                             "their enclosing solids, not they, as was assumed at import"}});
  const Json file{{"id", robot.id},
                  {"label", robot.label},
                  {"maker", robot.maker},
                  {"controller", robot.controller},
                  {"family", "chain"},
                  {"geometryMm", {{"joints", joints}, {"flange", poseJson(chain.last_T_flange)}}},
                  {"limits", limits},
                  {"links", links},
                  {"neverMeet", never},
                  {"sources", {source}},
                  {"assumed", robot.assumed}};
  return file.dump(2) + "\n";
}

} // namespace voluta::robot
