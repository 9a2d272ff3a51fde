#include "base/files.h"
#include "cli/commands.h"
#include "process/library.h"

#include <fmt/format.h>

namespace voluta::cli {

using process::Shelf;

ExitCode processListCommand(const ProcessOptions&) {
  for (const std::string& id : process::libraryIds(Shelf::Processes)) {
    const bool own = !process::comesWithProgram(Shelf::Processes, id);
    fmt::print("{:<18} {}{}\n", id, process::labelOrProblem(Shelf::Processes, id),
               own ? " (own)" : "");
  }
  return kDone;
}

ExitCode processShowCommand(const ProcessOptions& options) {
  fmt::print("{}", process::itemText(process::loadItem(Shelf::Processes, options.process)));
  return kDone;
}

ExitCode processCheckCommand(const ProcessOptions& options) {
  fmt::print("{}: no problems\n", process::loadItem(Shelf::Processes, options.process).label());
  return kDone;
}

ExitCode processImportCommand(const ProcessOptions& options) {
  fmt::print("{}\n", process::importItem(Shelf::Processes, options.process).string());
  return kDone;
}

ExitCode processExportCommand(const ProcessOptions& options) {
  base::writeFile(options.file,
                  process::itemText(process::loadItem(Shelf::Processes, options.process)));
  return kDone;
}

} // namespace voluta::cli
