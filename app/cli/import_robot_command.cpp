#include "base/data_files.h"
#include "cells/arm_import.h"
#include "cli/commands.h"
#include "cli/run_interruptibly.h"
#include "process/process.h"
#include "program/dialect.h"
#include "project/choices.h"

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
  return "without a closed form, solved numerically: finds nearly all branches, and planning takes "
         "longer";
}

std::filesystem::path folderOf(const ImportRobotOptions& asked) {
  if (asked.folder.empty() && base::userDataFolder().empty())
    throw base::Error(base::ErrorCode::Usage, "no data folder for your own robots"_text, {},
                      "give a folder: -o DIR"_text);
  if (std::filesystem::is_regular_file(asked.folder) || asked.folder.extension() == ".json")
    throw base::Error(base::ErrorCode::Usage,
                      "is a file; a folder for robots/ and cells/ is needed"_text,
                      asked.folder.string(), "give the robot's id with --id"_text);
  return asked.folder.empty() ? base::userDataFolder() : asked.folder;
}

} // namespace

ExitCode importRobotCommand(const ImportRobotOptions& asked) {
  program::findDialect(asked.options.controller); // Throws for an unknown format
  const std::filesystem::path folder = folderOf(asked);
  const robot::Mount nozzle = asked.cell == "fixed" ? robot::Mount::World : robot::Mount::Flange;
  const process::Process process = process::loadProcess(project::Choices().tool().process);
  const auto import = endedWith(runInterruptibly(
      [&](const base::RunContext& ctx) {
        return cells::importArm(asked.urdf, asked.options, nozzle, process, ctx);
      },
      asked.threads, {}, [] {}));
  if (!import) {
    fmt::print(stderr, "cancelled; nothing was written\n");
    return kCancelled;
  }
  const cells::ImportedFiles files = cells::writeImport(
      *import, folder, asked.replace ? cells::Existing::Replace : cells::Existing::Refuse);
  const robot::RobotModel& robot = import->arm.model;
  fmt::print("robot {} {}\n", robot.id, files.robot.string());
  fmt::print("cell {} {}\n", import->layout.cell.id, files.cell.string());
  fmt::print("arm: {}\n", solverOf(import->kind));
  fmt::print("cell: {}\n", import->layout.cell.note);
  for (const std::string& assumed : robot.assumed)
    fmt::print("assumed: {}\n", assumed);
  fmt::print("next: {}voluta-cli plan PART -o DIR --cell {} --scale fit\n",
             asked.folder.empty()
                 ? ""
                 : fmt::format("VOLUTA_DATA={} ", std::filesystem::absolute(folder).string()),
             import->layout.cell.id);
  return kDone;
}

} // namespace voluta::cli
