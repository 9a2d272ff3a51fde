#include "base/error.h"
#include "base/files.h"
#include "cli/commands.h"
#include "cli/new_file.h"
#include "process/head_shapes.h"
#include "process/library.h"
#include "process/library_fields.h"
#include "process/measured_sizes.h"

#include <fmt/format.h>

namespace voluta::cli {

using process::Shelf;

namespace {
std::string ownWords(const std::string& id) {
  try {
    const process::LibraryItem item = process::loadItem(Shelf::Processes, id);
    return item.inherits ? " (own, inherits from " + item.basedOn + ")" : " (own)";
  } catch (const base::Error&) {
    return " (own)";
  }
}
} // namespace

ExitCode processListCommand(const ProcessOptions&) {
  for (const std::string& id : process::libraryIds(Shelf::Processes)) {
    const bool own = !process::comesWithProgram(Shelf::Processes, id);
    fmt::print("{:<18} {}{}\n", id, process::labelOrProblem(Shelf::Processes, id),
               own ? ownWords(id) : "");
  }
  return kDone;
}

ExitCode processShowCommand(const ProcessOptions& options) {
  fmt::print("{}", process::itemText(process::loadItem(Shelf::Processes, options.process)));
  return kDone;
}

ExitCode processCheckCommand(const ProcessOptions& options) {
  const process::LibraryItem item = process::loadItem(Shelf::Processes, options.process);
  process::checkItem(item, options.process);
  const auto problem = process::upsideDown(item.process()->head);
  fmt::print("{}: {}\n", item.label(), problem ? base::english(*problem) : "no problems");
  return problem ? kNotAll : kDone;
}

ExitCode processImportCommand(const ProcessOptions& options) {
  fmt::print("{}\n", process::importItem(Shelf::Processes, options.process).string());
  return kDone;
}

ExitCode processExportCommand(const ProcessOptions& options) {
  requireNewFile(options.file, options.replace);
  base::writeFile(options.file,
                  process::itemText(process::loadItem(Shelf::Processes, options.process)));
  return kDone;
}

void sayDifferences(const process::LibraryItem& first, const process::LibraryItem& second) {
  const auto said = [](const process::FieldDifference& row, const base::ParameterValue& value) {
    const double* number = std::get_if<double>(&value);
    return number && !row.none.empty() && *number == row.spec.minimum
               ? base::english(row.none)
               : base::formatParameter(value) + (row.spec.unit.empty() ? "" : " " + row.spec.unit);
  };
  for (const process::FieldDifference& row : process::differences(first, second))
    fmt::print("{}: {} | {}\n", row.spec.key, said(row, row.first), said(row, row.second));
}

ExitCode processCompareCommand(const ProcessOptions& options) {
  sayDifferences(process::loadItem(Shelf::Processes, options.process),
                 process::loadItem(Shelf::Processes, options.other));
  return kDone;
}

ExitCode processSizesCommand(const ProcessOptions& options) {
  requireNewFile(options.file, options.replace);
  process::LibraryItem item = process::loadItem(Shelf::Processes, options.process);
  const std::vector<process::MeasuredSize> sizes =
      process::readMeasuredSizes(base::readFile(options.table), options.table.string());
  const process::SizeFit fit = process::fitSizes(sizes, *item.process());
  fmt::print("scaleX {:.6g}\nscaleY {:.6g}\noutlineOffsetMm {:.4g}\nholeOffsetMm {:.4g}\n"
             "{} sizes, within {:.3f} mm of the fitted law\n",
             fit.process.scaleX, fit.process.scaleY, fit.process.outlineOffsetMm,
             fit.process.holeOffsetMm, sizes.size(), fit.residualMm);
  constexpr double kPercent = 100.0;
  for (const auto& [axis, deviation] :
       {std::pair('x', fit.scaleDeviationX), std::pair('y', fit.scaleDeviationY)})
    if (!process::tellsScale(deviation))
      fmt::print(
          "the sizes do not tell scale{} from an excess: it is uncertain by {:.2f} %; measure "
          "a short and a long length along {}\n",
          axis == 'x' ? 'X' : 'Y', kPercent * deviation, axis);
  if (options.file.empty())
    return kDone;
  const bool isShipped = process::comesWithProgram(Shelf::Processes, item.id());
  const std::string id = isShipped ? options.file.stem().string() : item.id();
  if (isShipped)
    item.basedOn = item.id();
  item.data = fit.process;
  base::writeFile(options.file, process::itemText(item.named(id, item.label())));
  return kDone;
}

} // namespace voluta::cli
