#include "pipeline/larger_cell.h"

#include "base/error.h"
#include "base/outcome.h"
#include "modes/cell_choice.h"
#include "modes/mode_table.h"

#include <Eigen/Geometry>
#include <tuple>

namespace voluta::pipeline {

namespace {

// Longer side of the largest plate, mm; 0 without plates.
double plateLengthMm(const robot::Cell& cell) {
  if (cell.plates().empty())
    return 0.0;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : project::Platform(cell.plates().back()).plateAround({}))
    box.extend(corner);
  return box.sizes().maxCoeff();
}

} // namespace

std::optional<std::string> cellWithLargerPlate(const project::Choices& choices) {
  const modes::Mode& mode = modes::findMode(choices.mode);
  if (mode.aroundRod)
    return std::nullopt;
  const process::Process process = process::loadProcess(choices.process);
  const robot::Cell now = modes::cellOnAnyPlatform(choices, process);
  const double length = plateLengthMm(now);
  std::optional<std::string> best;
  std::tuple<bool, double> bestRank;
  for (const std::string& id : robot::cellIds()) {
    project::Choices other = choices;
    other.cell = id;
    // A cell of the user's own that cannot be read is none to offer.
    const auto read = base::outcomeOf([&] { return modes::cellOnAnyPlatform(other, process); });
    const auto* cell = std::get_if<robot::Cell>(&read);
    if (!cell || cell->rod() || (now.tilts() && !cell->tilts()))
      continue;
    const std::tuple rank(cell->nozzleMount() != now.nozzleMount(), plateLengthMm(*cell));
    if (std::get<double>(rank) > length && (!best || rank < bestRank)) {
      best = id;
      bestRank = rank;
    }
  }
  return best;
}

} // namespace voluta::pipeline
