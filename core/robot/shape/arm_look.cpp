#include "robot/shape/arm_look.h"

#include "base/data_files.h"
#include "base/json_node.h"
#include "robot/shape/default_shape.h"

#include <algorithm>

namespace voluta::robot {

namespace {

std::vector<ShapeSolid> shapeOf(const RobotModel& robot) {
  try {
    const base::JsonNode top =
        base::JsonNode::readFile(base::dataFile("robots", robot.id, "unknown robot '{id}'"_text));
    if (top.has("shape"))
      return readArmShape(top.at("shape"), robot.dof());
  } catch (const base::Error&) {
    // Fall back to the default shape.
  }
  return defaultShape(robot);
}

} // namespace

ArmLook lookOf(const RobotModel& robot) {
  ArmLook look{linkMeshesOf(robot.id), shapeOf(robot)};
  std::erase_if(look.solids, [&](const ShapeSolid& solid) {
    return std::ranges::find(look.meshes, solid.frame, &LinkMesh::frame) != look.meshes.end();
  });
  return look;
}

} // namespace voluta::robot
