#include "base/data_files.h"
#include "base/units.h"
#include "cells/nozzle_place.h"
#include "cli/commands.h"
#include "cli/run_interruptibly.h"
#include "pipeline/cell_reach.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace voluta::cli {

namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const cells::ReachMap& map, const std::string& cell) {
  Json tilts = Json::array(), points = Json::array();
  const double highest = map.grid().heightsMm.back();
  for (std::size_t tilt = 0; tilt < map.grid().tiltsRad.size(); ++tilt)
    tilts.push_back({{"tiltDeg", base::radiansToDegrees(map.grid().tiltsRad[tilt])},
                     {"share", map.shareOfTilt(tilt)}});
  for (std::size_t n = 0; n < map.points().size(); ++n) {
    Json row{{"xMm", map.points()[n].x()}, {"yMm", map.points()[n].y()}};
    row["share"] = map.share(n, highest, map.grid().tiltsRad.back());
    row["uprightShare"] = map.share(n, highest, 0.0);
    points.push_back(std::move(row));
  }
  return {{"cell", cell},
          {"spacingMm", map.grid().spacingMm},
          {"heightsMm", map.grid().heightsMm},
          {"azimuths", map.grid().azimuths},
          {"turns", map.grid().turns},
          {"tilts", std::move(tilts)},
          {"points", std::move(points)}};
}

// Prints tenths of the poses over each point, the plate seen from above, x to the right; * for all.
void drawMap(const cells::ReachMap& map) {
  Eigen::Vector2i low = map.lattice().front(), high = low;
  for (const Eigen::Vector2i& at : map.lattice()) {
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  const auto width = static_cast<std::size_t>(2 * (high.x() - low.x() + 1));
  std::vector<std::string> rows(static_cast<std::size_t>(high.y() - low.y() + 1),
                                std::string(width, ' '));
  for (std::size_t n = 0; n < map.points().size(); ++n) {
    const double share = map.share(n, map.grid().heightsMm.back(), map.grid().tiltsRad.back());
    const Eigen::Vector2i at = map.lattice()[n];
    rows[static_cast<std::size_t>(high.y() - at.y())]
        [static_cast<std::size_t>(2 * (at.x() - low.x()))] =
            share == 1.0 ? '*'
                         : static_cast<char>('0' + static_cast<int>(std::floor(10.0 * share)));
  }
  for (const std::string& row : rows)
    fmt::print("  {}\n", row.substr(0, row.find_last_not_of(' ') + 1));
}

void say(const cells::ReachMap& map, const std::string& cell) {
  fmt::print("{}: {} points every {:g} mm, heights {:g} to {:g} mm; poses reached by tilt:\n", cell,
             map.points().size(), map.grid().spacingMm, map.grid().heightsMm.front(),
             map.grid().heightsMm.back());
  for (std::size_t tilt = 0; tilt < map.grid().tiltsRad.size(); ++tilt)
    fmt::print("  {:>3.0f} deg {:>6.1f} %\n", base::radiansToDegrees(map.grid().tiltsRad[tilt]),
               100.0 * map.shareOfTilt(tilt));
  fmt::print("tenths of the poses at each point of the plate (x to the right, * all):\n");
  drawMap(map);
}

} // namespace

ExitCode cellReachCommand(const ReachOptions& options) {
  const auto map = endedWith(runInterruptibly(
      [&options](const base::RunContext& ctx) {
        return pipeline::cellReach(pipeline::resolve(options.choices), options.heightMm, ctx);
      },
      options.threads, {}, [] {}));
  if (!map)
    return kCancelled;
  if (options.json)
    fmt::print("{}\n", jsonOf(*map, base::dataName(options.choices.cell)).dump(2));
  else
    say(*map, base::dataName(options.choices.cell));
  return kDone;
}

ExitCode cellNozzleCommand(const ReachOptions& options, const base::RunContext& ctx) {
  const process::Process process = process::loadProcess(options.choices.tool().process);
  const robot::Cell cell = pipeline::cellToMap(options.choices, process);
  if (cell.nozzleMount() != robot::Mount::World)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("in cell {cell} the nozzle moves with the arm"_text, cell.id()),
                      {}, "choose a cell with a stationary nozzle"_text);
  cells::NozzleSearch search;
  search.flange_T_work = cell.flange_T_moved();
  const auto frames = cells::reachableFrames(cell.robot(), search);
  ctx.checkpoint();
  const cells::NozzlePlace place = cells::bestNozzlePlace(frames, search.stepMm, search.boxSteps);
  const Eigen::Vector3d now = cell.base_T_fixed().translation();
  const Eigen::Vector3d box = search.stepMm * search.boxSteps.cast<double>();
  const std::size_t framesNow = cells::framesInBox(frames, now, box);
  if (options.json)
    fmt::print("{}\n", Json{{"cell", cell.id()},
                            {"samples", search.samples},
                            {"facingUp", frames.size()},
                            {"boxMm", {box.x(), box.y(), box.z()}},
                            {"bestMm", {place.at.x(), place.at.y(), place.at.z()}},
                            {"frames", place.frames},
                            {"nowMm", {now.x(), now.y(), now.z()}},
                            {"framesNow", framesNow}}
                           .dump(2));
  else
    fmt::print("{}: of {} sampled frames of the plate, {} do not face down; a box of"
               " {:g} mm around the nozzle contains the most at ({:g}, {:g}, {:g}): "
               "{}; at the present position ({:g}, {:g}, {:g}): {}\n",
               cell.id(), search.samples, frames.size(), box.x(), place.at.x(), place.at.y(),
               place.at.z(), place.frames, now.x(), now.y(), now.z(), framesNow);
  return kDone;
}

} // namespace voluta::cli
