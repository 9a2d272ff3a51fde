#include "base/data_files.h"
#include "base/files.h"
#include "cli/commands.h"
#include "program/dialect.h"
#include "robot/chain_kinematics.h"
#include "robot/robot_file_writer.h"

#include <fmt/format.h>

namespace voluta::cli {

namespace {

const char* solverOf(robot::ArmKind kind) {
  switch (kind) {
  case robot::ArmKind::SphericalWrist:
    return "ortho-parallel with a spherical wrist, solved in closed form";
  case robot::ArmKind::ParallelAxes:
    return "axes 2-4 parallel, solved in closed form";
  case robot::ArmKind::BentWrist:
    return "ortho-parallel with a bent wrist, solved by a search over the last joint";
  case robot::ArmKind::Other:
    break;
  }
  return "of no kind with a closed form, solved numerically: nearly all branches, and slowly";
}

} // namespace

ExitCode importRobotCommand(const ImportRobotOptions& asked) {
  robot::UrdfOptions options = asked.options;
  program::findDialect(options.controller); // throws where there is none
  // A robot's file is named as the robot is.
  if (options.id.empty() && !asked.file.empty())
    options.id = asked.file.stem().string();
  const robot::UrdfRobot robot = robot::readUrdf(asked.urdf, options);
  std::filesystem::path file = asked.file;
  if (file.empty()) {
    if (base::userDataFolder().empty())
      throw base::Error(base::ErrorCode::Usage, "no folder for robots of one's own"_text, {},
                        "name the file: -o FILE"_text);
    file = base::userDataFolder() / "robots" / (robot.model.id + ".json");
    std::filesystem::create_directories(file.parent_path());
  } else if (file.stem().string() != robot.model.id) {
    throw base::Error(base::ErrorCode::Usage,
                      base::message("--id '{id}': a robot's file is named as the robot is, not "
                                    "'{file}'"_text,
                                    robot.model.id, file.filename().string()));
  }
  base::writeFile(file, robot::robotFileJson(robot.model, robot.chain, robot.source));
  fmt::print("{} {}\n", robot.model.id, file.string());
  fmt::print("arm: {}\n", solverOf(robot::ChainKinematics(robot.chain).kind()));
  for (const std::string& assumed : robot.model.assumed)
    fmt::print("assumed: {}\n", assumed);
  return kDone;
}

} // namespace voluta::cli
