#include "base/files.h"
#include "base/number_list.h"
#include "cli/commands.h"
#include "robot/measured_json.h"

#include <fmt/format.h>
#include <optional>

namespace voluta::cli {

namespace {
robot::NumberRows rowsOf(const std::filesystem::path& file) {
  return base::readRows(base::readFile(file), file.string());
}
} // namespace

ExitCode cellFrameCommand(const MeasuredOptions& options) {
  const robot::NumberRows rows = rowsOf(options.table);
  fmt::print("{}\n", robot::frameJson(robot::frameOfRows(rows), rows.size()));
  return kDone;
}

ExitCode cellTipCommand(const MeasuredOptions& options) {
  const robot::NumberRows rows = rowsOf(options.table);
  std::optional<robot::RobotModel> robot;
  if (!options.robot.empty())
    robot = robot::loadRobot(options.robot);
  fmt::print("{}\n",
             robot::tipJson(robot::tipOfRows(rows, robot ? &*robot : nullptr), rows.size()));
  return kDone;
}

} // namespace voluta::cli
