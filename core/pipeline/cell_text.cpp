#include "pipeline/cell_text.h"

#include "base/data_files.h"
#include "base/json_node.h"
#include "project/content_hash.h"
#include "robot/cell/robot_reader.h"
#include "robot/planning_text.h"

#include <fmt/format.h>

namespace voluta::pipeline {

std::string cellText(const robot::Cell& cell, const std::string& choice) {
  const std::string text = base::dataText("cells", choice, "unknown cell '{id}'"_text).text;
  const std::string hash = project::contentHash(text);
  const std::string& robot = cell.robot().id;
  const base::JsonNode described = base::JsonNode::parse(text, cell.id()).at("robot");
  const std::string robotHash =
      robot::holdsRobot(described)
          ? hash
          : project::contentHash(robot::planningText(
                base::dataText("robots", robot, "unknown robot '{id}'"_text).text));
  return fmt::format("cell {} {}\nrobot {} {}\n", cell.id(), hash, robot, robotHash);
}

} // namespace voluta::pipeline
