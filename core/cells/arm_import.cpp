#include "cells/arm_import.h"

#include "base/error.h"
#include "base/files.h"
#include "robot/cell/robot_file_writer.h"
#include "robot/kinematics/chain_kinematics.h"

#include <algorithm>
#include <fmt/format.h>

namespace voluta::cells {

namespace {

namespace fs = std::filesystem;

bool comesAlong(const std::string& id) {
  std::error_code none;
  return fs::exists(base::resourceFolder() / "robots" / (id + ".json"), none);
}

// Names of a cell's bodies must be unique.
void freeNames(robot::RobotModel& robot) {
  for (robot::Body& link : robot.links)
    for (const char* taken : {"table", "holder", "head", "platform"})
      if (link.name == taken)
        link.name += " link";
}

void addPairs(const std::vector<std::pair<int, int>>& pairs, const char* when,
              robot::RobotModel& robot) {
  for (const auto& [a, b] : pairs) {
    robot.neverMeet.emplace_back(a, b);
    robot.assumed.push_back(fmt::format("'{}' and '{}' are not checked against each other: their "
                                        "solids are near each other {}",
                                        robot.links[static_cast<std::size_t>(a)].name,
                                        robot.links[static_cast<std::size_t>(b)].name, when));
  }
}

} // namespace

ArmImport importArm(const fs::path& urdf, const robot::UrdfOptions& options, robot::Mount nozzle,
                    const process::Process& process, const base::RunContext& ctx) {
  if (!options.id.empty() && comesAlong(options.id))
    throw base::Error(base::ErrorCode::Usage,
                      base::message("'{id}' is the name of a built-in robot"_text, options.id), {},
                      "give the arm another name: --id"_text);
  ctx.report(0.0, "the arm's description"_text);
  ArmImport import{robot::readUrdf(urdf, options), robot::ArmKind::Other, {}};
  robot::RobotModel& robot = import.arm.model;
  if (comesAlong(robot.id))
    robot.id += "-imported";
  freeNames(robot);
  import.kind = robot::ChainKinematics(import.arm.chain).kind();
  addPairs(neverNear(robot), "at most poses", robot);
  import.layout = layOut(robot, nozzle, process, ctx.sub(0.05, 1.0));
  addPairs(import.layout.meetAtRest, "at rest", robot);
  robot.assumed.insert(robot.assumed.end(), import.layout.notes.begin(), import.layout.notes.end());
  import.linkMeshes = robot::urdfLinkMeshes(urdf, options);
  return import;
}

namespace {
ImportedFiles filesOf(const ArmImport& import, const fs::path& folder) {
  return {folder / "robots" / (import.arm.model.id + ".json"),
          folder / "cells" / (import.layout.cell.id + ".json")};
}
} // namespace

std::vector<fs::path> conflictingFiles(const ArmImport& import, const fs::path& folder) {
  const ImportedFiles files = filesOf(import, folder);
  std::vector<fs::path> there;
  for (const fs::path& file : {files.robot, files.cell}) {
    std::error_code none;
    if (fs::exists(file, none))
      there.push_back(file);
  }
  return there;
}

ImportedFiles writeImport(const ArmImport& import, const fs::path& folder, Existing existing) {
  const robot::RobotModel& robot = import.arm.model;
  const ImportedFiles files = filesOf(import, folder);
  const std::vector<fs::path> there = conflictingFiles(import, folder);
  if (existing == Existing::Refuse && !there.empty())
    throw base::Error(
        base::ErrorCode::Usage, "exists, perhaps with measured frames and obstacles"_text,
        there.back().string(), "give another name, --id, or replace it: --replace"_text);
  for (const fs::path& file : {files.robot, files.cell}) {
    std::error_code failed;
    fs::create_directories(file.parent_path(), failed);
    if (failed)
      throw base::Error(base::ErrorCode::CannotWrite,
                        base::message("cannot be written: {why}"_text, failed.message()),
                        file.parent_path().string());
  }
  base::writeFile(files.robot, robot::robotFileJson(robot, import.arm.chain, import.arm.source));
  robot::writeLinkMeshes(files.robot, import.linkMeshes);
  base::writeFile(files.cell,
                  robot::cellFileJson(import.layout.cell, robot::kindsOf(robot.limits)));
  return files;
}

} // namespace voluta::cells
