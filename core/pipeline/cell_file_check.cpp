#include "pipeline/cell_file_check.h"

#include "base/error.h"
#include "curved/platform_polygon.h"
#include "pipeline/cell_reach.h"
#include "project/platform.h"

namespace voluta::pipeline {

robot::Cell cellOfText(const std::string& text, const std::string& id,
                       const process::Process& process) {
  const std::string file = id + ".json";
  robot::Cell cell =
      robot::Cell::readText(text, file, process, curved::platformDisc(kPlateOfNoneMm));
  if (cell.plates().empty())
    return cell;
  return robot::Cell::readText(text, file, process,
                               project::Platform(cell.plates().back()).plateAround({}));
}

CheckedCell checkedCell(const std::string& text, const std::string& id,
                        const process::Process& process, double partKg,
                        const base::RunContext& ctx) {
  CheckedCell checked;
  try {
    checked.cell = std::make_shared<const robot::Cell>(cellOfText(text, id, process));
    checked.faults = cells::cellFaults(*checked.cell, process, partKg, ctx);
  } catch (const base::Error& error) {
    checked.faults.push_back({error.message(), error.remedy()});
  }
  return checked;
}

} // namespace voluta::pipeline
