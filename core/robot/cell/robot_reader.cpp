// A robot's file (resources/robots/ID.json; the file's name is its id). All keys are required
// unless marked optional; an unknown key is an error.
//   id, label, maker      texts; id as the file's name
//   controller            id of the program format its controller reads, e.g. "urscript"
//   controllerModel       optional: the controller's model if programs depend on it: "omnicore"
//                         (ABB with RobotWare 7)
//   family                kinematic family: "ur" | "opw" (ortho-parallel with a spherical wrist) |
//                         "chain" (any six turning axes) | "scara" (two upright axes and a shaft
//                         that slides and turns) | "gantry" (slides along x, y and z, and the
//                         nozzle's rotation)
//   geometryMm            the family's lengths; ur: {d1, a2, a3, d4, d5, d6} of standard DH; opw:
//                         {a1, a2, b, c1, c2, c3, c4, offsetsDeg}, offsetsDeg: list of the
//                         controller's joint values with the arm upright; chain: {joints, flange}:
//                         joints a list of {pose, axis}, the pose of a joint's frame at zero in the
//                         frame of the link before it and its axis in its own, flange the flange's
//                         pose in the last; scara: {a1, a2, top}, both bars and the flange's height
//                         with joint 3 at 0; gantry: {}
//   reading               optional, if the controller counts joints differently from the family:
//                         {signs, offsetsDeg, thirdIsCoupled}, all optional, as JointReading; an
//                         offset of a sliding joint in mm
//   limits                list with an object for each joint, as the controller counts them:
//                         {minDeg, maxDeg, velocityDegPerS, accelerationDegPerS2}, of a sliding
//                         joint {minMm, maxMm, velocityMmPerS, accelerationMmPerS2}
//   links                 list of bodies {name, frame, shapes}; frame 0 is the base, n link n, in
//                         the frames of Kinematics::linkPoses; shapes as in
//                         robot/cell/shape_reader.h
//   neverMeet             optional list of {pair: [name, name], why}: links that need no check
//   payloadKg             optional: payload at the flange
//   payloadCurve          optional list of {offsetMm, kg}: payload by the distance of the load's
//                         centre from the flange, as in robot/payload_curve.h
//   sources               optional list of texts: sources of the numbers
//   assumed               list of texts: values without a published source
//   shape                 optional: its appearance, as in robot/shape/arm_shape.h; read only for
//                         drawing
#include "robot/cell/robot_reader.h"

#include "base/json_node.h"
#include "robot/cell/joint_reading.h"
#include "robot/cell/json_pose.h"
#include "robot/cell/limits_reader.h"
#include "robot/cell/shape_reader.h"
#include "robot/kinematics/chain_kinematics.h"
#include "robot/kinematics/gantry_kinematics.h"
#include "robot/kinematics/opw_kinematics.h"
#include "robot/kinematics/scara_kinematics.h"
#include "robot/kinematics/ur_kinematics.h"
#include "robot/payload_curve.h"
#include "robot/robot_model.h"
#include "robot/shape/arm_shape.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace voluta::robot {

namespace {

std::shared_ptr<const Kinematics> urFamily(const base::JsonNode& g) {
  g.allowOnly({"d1", "a2", "a3", "d4", "d5", "d6"});
  const UrGeometry geometry{g.at("d1").number(), g.at("a2").number(), g.at("a3").number(),
                            g.at("d4").number(), g.at("d5").number(), g.at("d6").number()};
  for (const char* key : {"a2", "a3", "d6"})
    if (g.at(key).number() == 0.0)
      g.at(key).fail("must not be 0"_text);
  return std::make_shared<UrKinematics>(geometry);
}

std::shared_ptr<const Kinematics> opwFamily(const base::JsonNode& g) {
  g.allowOnly({"a1", "a2", "b", "c1", "c2", "c3", "c4", "offsetsDeg"});
  OpwGeometry geometry{
      g.at("a1").number(),   g.at("a2").number(),   g.at("b").number(),  g.at("c1").number(),
      g.at("c2").positive(), g.at("c3").positive(), g.at("c4").number(), {}};
  const std::vector<base::JsonNode> offsets = g.at("offsetsDeg").items();
  if (offsets.size() != geometry.offsets.size())
    g.at("offsetsDeg").fail(base::message("must have 6 joints, has {found}"_text, offsets.size()));
  for (std::size_t i = 0; i < offsets.size(); ++i)
    geometry.offsets[i] = base::degreesToRadians(offsets[i].number());
  return std::make_shared<OpwKinematics>(geometry);
}

std::shared_ptr<const Kinematics> chainFamily(const base::JsonNode& g) {
  g.allowOnly({"joints", "flange"});
  SerialChain chain;
  for (const base::JsonNode& joint : g.at("joints").items()) {
    joint.allowOnly({"pose", "axis"});
    const Eigen::Vector3d axis = readVector3(joint.at("axis"));
    if (axis.norm() == 0.0)
      joint.at("axis").fail("must not have zero length"_text);
    chain.joints.push_back({readPose(joint.at("pose")), axis.normalized()});
  }
  if (chain.joints.size() != 6)
    g.at("joints").fail(base::message("must have 6 joints, has {found}"_text, chain.joints.size()));
  chain.last_T_flange = readPose(g.at("flange"));
  return std::make_shared<ChainKinematics>(std::move(chain));
}

std::shared_ptr<const Kinematics> scaraFamily(const base::JsonNode& g) {
  g.allowOnly({"a1", "a2", "top"});
  return std::make_shared<ScaraKinematics>(
      ScaraGeometry{g.at("a1").positive(), g.at("a2").positive(), g.at("top").number()});
}

std::shared_ptr<const Kinematics> gantryFamily(const base::JsonNode& g) {
  g.allowOnly({});
  return std::make_shared<GantryKinematics>();
}

// A new family is a row here and a file beside ur_kinematics.cpp.
struct Family {
  const char* id;
  std::function<std::shared_ptr<const Kinematics>(const base::JsonNode&)> make;
};
const std::vector<Family>& families() {
  static const std::vector<Family> table = {{"ur", urFamily},
                                            {"opw", opwFamily},
                                            {"chain", chainFamily},
                                            {"scara", scaraFamily},
                                            {"gantry", gantryFamily}};
  return table;
}

std::vector<double> numbersOf(const base::JsonNode& node, int dof) {
  std::vector<double> numbers;
  for (const base::JsonNode& number : node.items())
    numbers.push_back(number.number());
  if (static_cast<int>(numbers.size()) != dof)
    node.fail(base::message("must have {wanted} joints, has {found}"_text, dof, numbers.size()));
  return numbers;
}

std::shared_ptr<const Kinematics> asRead(std::shared_ptr<const Kinematics> arm,
                                         const base::JsonNode& node) {
  node.allowOnly({"signs", "offsetsDeg", "thirdIsCoupled"});
  const auto dof = static_cast<std::size_t>(arm->dof());
  JointReading reading{std::vector<double>(dof, 1.0), std::vector<double>(dof, 0.0), false};
  if (node.has("signs")) {
    reading.signs = numbersOf(node.at("signs"), arm->dof());
    for (const double sign : reading.signs)
      if (std::abs(sign) != 1.0)
        node.at("signs").fail("must be 1 or -1"_text);
  }
  if (node.has("offsetsDeg")) {
    reading.offsets = numbersOf(node.at("offsetsDeg"), arm->dof());
    for (std::size_t i = 0; i < dof; ++i)
      reading.offsets[i] = ofShownValue(arm->kindOf(static_cast<int>(i)), reading.offsets[i]);
  }
  reading.thirdIsCoupled = node.has("thirdIsCoupled") && node.at("thirdIsCoupled").boolean();
  return std::make_shared<ReadKinematics>(std::move(arm), std::move(reading));
}

std::shared_ptr<const Kinematics> readKinematics(const base::JsonNode& robot) {
  const std::string id = robot.at("family").text();
  for (const Family& family : families())
    if (id == family.id) {
      auto arm = family.make(robot.at("geometryMm"));
      return robot.has("reading") ? asRead(std::move(arm), robot.at("reading")) : arm;
    }
  robot.at("family").fail(base::message("names an unknown kinematic family: '{id}'"_text, id));
}

std::vector<JointLimits> readLimits(const base::JsonNode& list, const Kinematics& arm) {
  const std::vector<base::JsonNode> joints = list.items();
  if (static_cast<int>(joints.size()) != arm.dof())
    list.fail(
        base::message("must have {wanted} joints, has {found}"_text, arm.dof(), joints.size()));
  std::vector<JointLimits> limits;
  for (const base::JsonNode& joint : joints) {
    const JointKind kind = arm.kindOf(static_cast<int>(limits.size()));
    if (kind == JointKind::Sliding)
      joint.allowOnly({"minMm", "maxMm", "velocityMmPerS", "accelerationMmPerS2"});
    else
      joint.allowOnly({"minDeg", "maxDeg", "velocityDegPerS", "accelerationDegPerS2"});
    limits.push_back(readJointLimits(joint, kind));
  }
  return limits;
}

std::vector<Body> readLinks(const base::JsonNode& list, int dof) {
  std::vector<Body> links;
  for (const base::JsonNode& node : list.items()) {
    node.allowOnly({"name", "frame", "shapes"});
    Body link;
    link.name = node.at("name").text();
    link.role = BodyRole::Link;
    link.frame = node.at("frame").integer();
    if (link.frame < 0 || link.frame > dof)
      node.at("frame").fail(base::message("must be in 0..{dof}"_text, dof));
    for (const Body& other : links)
      if (other.name == link.name)
        node.at("name").fail(base::message("is already used: '{name}'"_text, link.name));
    link.shapes = readShapes(node.at("shapes"));
    links.push_back(std::move(link));
  }
  return links;
}

std::vector<std::string> readTexts(const base::JsonNode& list) {
  std::vector<std::string> texts;
  for (const base::JsonNode& node : list.items())
    texts.push_back(node.text());
  return texts;
}

} // namespace

RobotModel readRobot(const std::filesystem::path& file) {
  const base::JsonNode top = base::JsonNode::readFile(file);
  const std::string id = top.at("id").text();
  if (id != file.stem().string())
    top.at("id").fail(
        base::message("is '{id}', but the file is named '{file}'"_text, id, file.stem().string()));
  return readRobot(top);
}

bool holdsRobot(const base::JsonNode& robot) {
  return robot.has("id");
}

RobotModel readRobot(const base::JsonNode& top) {
  top.allowOnly({"id", "label", "maker", "controller", "controllerModel", "family", "geometryMm",
                 "reading", "limits", "links", "neverMeet", "payloadKg", "payloadCurve", "sources",
                 "assumed", "shape"});
  RobotModel robot;
  robot.id = top.at("id").text();
  robot.label = top.at("label").text();
  robot.maker = top.at("maker").text();
  robot.controller = top.at("controller").text();
  if (top.has("controllerModel"))
    robot.controllerModel = top.at("controllerModel").text();
  robot.kinematics = readKinematics(top);
  robot.limits = readLimits(top.at("limits"), *robot.kinematics);
  robot.links = readLinks(top.at("links"), robot.dof());
  robot.assumed = readTexts(top.at("assumed"));
  if (top.has("payloadKg"))
    robot.payloadKg = top.at("payloadKg").positive();
  if (top.has("payloadCurve"))
    readPayloadCurve(top.at("payloadCurve"));
  if (top.has("sources"))
    readTexts(top.at("sources"));
  if (top.has("shape"))
    readArmShape(top.at("shape"), robot.dof());
  if (top.has("neverMeet"))
    for (const auto& [a, b] : readBodyPairs(top.at("neverMeet"), robot.links))
      robot.neverMeet.emplace_back(a, b);
  return robot;
}

} // namespace voluta::robot
