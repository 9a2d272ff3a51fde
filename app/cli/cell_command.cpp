#include "base/data_files.h"
#include "base/files.h"
#include "base/number_list.h"
#include "cli/commands.h"
#include "cli/new_file.h"
#include "curved/platform_polygon.h"
#include "pipeline/cell_file_check.h"
#include "robot/cell_draft.h"
#include "robot/measured/measured_json.h"

#include <fmt/format.h>
#include <optional>

namespace voluta::cli {

namespace {
constexpr double kAnyPlateMm = 80.0;

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

ExitCode cellImportCommand(const CellFileOptions& options) {
  const std::filesystem::path file = options.cell;
  robot::Cell::read(file, process::loadProcess("fdm-1.0"), curved::platformDisc(kAnyPlateMm));
  const robot::CellDraft draft(robot::selfContainedCell(file));
  fmt::print("{}\n", robot::saveOwnCell(draft).string());
  return kDone;
}

ExitCode cellExportCommand(const CellFileOptions& options) {
  requireNewFile(options.file, options.replace);
  base::writeFile(options.file, robot::selfContainedCell(base::dataFile(
                                    "cells", options.cell, "unknown cell '{id}'"_text)));
  return kDone;
}

ExitCode cellCheckCommand(const CheckCellOptions& options, const base::RunContext& ctx) {
  const std::filesystem::path file =
      base::isDataFileName(options.cell)
          ? std::filesystem::path(options.cell)
          : base::dataFile("cells", options.cell, "unknown cell '{id}'"_text);
  const process::Process process = base::isDataFileName(options.process)
                                       ? process::readProcess(options.process)
                                       : process::loadProcess(options.process);
  const pipeline::CheckedCell checked = pipeline::checkedCell(
      base::readFile(file), file.stem().string(), process, options.partKg, ctx);
  for (const cells::CellFault& fault : checked.faults)
    fmt::print("{}\n", fault.remedy.empty() ? base::english(fault.what)
                                            : fmt::format("{} ({})", base::english(fault.what),
                                                          base::english(fault.remedy)));
  if (!checked.cell)
    return kUnusableInput;
  if (checked.faults.empty())
    fmt::print("no problems\n");
  return checked.faults.empty() ? kDone : kNotAll;
}

} // namespace voluta::cli
