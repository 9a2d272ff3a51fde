#include "pipeline/larger_cell.h"

#include "base/error.h"
#include "base/outcome.h"
#include "geometry/convex_polygon.h"
#include "modes/cell_choice.h"
#include "modes/mode_table.h"
#include "pipeline/cell_plate.h"
#include "pipeline/stage_options.h"

#include <Eigen/Geometry>
#include <tuple>
#include <vector>

namespace voluta::pipeline {

namespace {

using Polygon = std::vector<Eigen::Vector2d>;

// Returns the plate's longer side [mm].
double lengthMm(const Polygon& plate) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : plate)
    box.extend(corner);
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

// Returns whether the plate carries a foot of this size at its centre, rotated by 0 or 90 degrees.
bool carries(const Polygon& plate, const Eigen::Vector2d& foot) {
  const auto isOn = [&](double x, double y) {
    return geometry::inConvexPolygon(plate, {x, y}) && geometry::inConvexPolygon(plate, {-x, y}) &&
           geometry::inConvexPolygon(plate, {-x, -y}) && geometry::inConvexPolygon(plate, {x, -y});
  };
  const Eigen::Vector2d half = 0.5 * foot;
  return isOn(half.x(), half.y()) || isOn(half.y(), half.x());
}

} // namespace

std::optional<std::string> cellWithLargerPlate(const project::Choices& choices,
                                               const Eigen::Vector2d& footMm) {
  const modes::Mode& mode = modes::findMode(choices.item().mode);
  if (mode.aroundRod)
    return std::nullopt;
  const process::Process process = process::loadProcess(choices.tool(ownTool(choices)).process);
  const robot::Cell now = modes::cellOnAnyPlatform(choices, process);
  const double length = lengthMm(largestPlate(now));
  std::optional<std::string> best;
  std::tuple<bool, double> bestRank;
  for (const std::string& id : robot::cellIds()) {
    project::Choices other = choices;
    other.cell = id;
    // Skip a cell of the user that cannot be read.
    const auto read = base::outcomeOf([&] { return modes::cellOnAnyPlatform(other, process); });
    const auto* cell = std::get_if<robot::Cell>(&read);
    if (!cell || cell->rod() || (now.tilts() && !cell->tilts()))
      continue;
    const Polygon plate = largestPlate(*cell);
    const std::tuple rank(cell->nozzleMount() != now.nozzleMount(), lengthMm(plate));
    if (std::get<double>(rank) > length && carries(plate, footMm) && (!best || rank < bestRank)) {
      best = id;
      bestRank = rank;
    }
  }
  return best;
}

} // namespace voluta::pipeline
