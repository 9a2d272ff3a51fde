#include "base/data_files.h"
#include "cli/commands.h"
#include "cli/new_file.h"
#include "process/library.h"
#include "process/own_materials.h"

#include <fmt/format.h>

namespace voluta::cli {

ExitCode materialShowCommand(const MaterialOptions& options) {
  fmt::print("{}", process::materialText(process::chosenMaterial(options.material)));
  return kDone;
}

ExitCode materialCheckCommand(const MaterialOptions& options) {
  const process::Material material = process::chosenMaterial(options.material);
  process::checkItem({material, {}}, options.material);
  fmt::print("{}: no problems\n", material.label);
  return kDone;
}

ExitCode materialImportCommand(const MaterialOptions& options) {
  fmt::print("{}\n", process::importMaterial(options.material).string());
  return kDone;
}

ExitCode materialCompareCommand(const MaterialOptions& options) {
  sayDifferences(process::loadItem(process::Shelf::Materials, options.material),
                 process::loadItem(process::Shelf::Materials, options.other));
  return kDone;
}

ExitCode materialExportCommand(const MaterialOptions& options) {
  requireNewFile(options.file, options.replace);
  process::exportMaterial(options.material, options.file);
  return kDone;
}

} // namespace voluta::cli
