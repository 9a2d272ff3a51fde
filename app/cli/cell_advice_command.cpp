#include "base/error.h"
#include "base/files.h"
#include "base/outcome.h"
#include "base/units.h"
#include "cells/cell_layout.h"
#include "cli/commands.h"
#include "cli/new_file.h"
#include "cli/run_interruptibly.h"
#include "pipeline/cell_advice.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace voluta::cli {

namespace {

using Json = nlohmann::ordered_json;
using pipeline::CellAdvice;
using pipeline::CellComparison;

// What planning in a cell showed.
struct Planned {
  std::string verdict;
  std::optional<double> seconds; // of printing
  std::optional<long long> collisions;
};

Planned plannedIn(pipeline::PlanRequest request, const std::string& cell,
                  const base::RunContext& ctx) {
  request.choices.cell = cell;
  pipeline::takeOwnFiles(request.choices);
  const auto outcome = base::outcomeOf([&] { return pipeline::planPart(request, ctx); });
  if (std::holds_alternative<base::Cancelled>(outcome))
    throw base::Cancelled{};
  if (const auto* error = std::get_if<base::Error>(&outcome))
    return {base::english(error->whole()), {}, {}};
  const project::Report& report = std::get<pipeline::PlanResult>(outcome).job.report;
  return {pipeline::nothingBlocks(report) ? "clear" : "blocked", report.motion.durationS,
          static_cast<long long>(report.motion.collisions)};
}

struct Advised {
  CellComparison comparison;
  std::vector<Planned> planned; // per row, if asked for
};

Json jsonOf(const Advised& advised) {
  const CellComparison& all = advised.comparison;
  Json rows = Json::array();
  for (std::size_t i = 0; i < all.rows.size(); ++i) {
    const CellAdvice& row = all.rows[i];
    const auto orNull = [](const auto& value) { return value ? Json(*value) : Json(); };
    Json json{{"cell", row.cell},
              {"form", base::english(cells::traitsOf(row.form).name)},
              {"fitsScale", orNull(row.fitsScale)},
              {"reach", row.reach},
              {"uprightReach", row.uprightReach},
              {"flangeKg", row.load.kg},
              {"leverMm", row.load.leverMm},
              {"payloadKg", orNull(row.load.maxKg)},
              {"payloadByLever", row.load.byCurve},
              {"leanDeg", base::radiansToDegrees(row.leanRad)},
              {"out", row.out.empty() ? Json() : Json(base::english(row.out))}};
    if (i < advised.planned.size()) {
      json["verdict"] = advised.planned[i].verdict;
      json["printTimeS"] = orNull(advised.planned[i].seconds);
      json["collisions"] = orNull(advised.planned[i].collisions);
    }
    rows.push_back(std::move(json));
  }
  return {{"partKg", all.needs.kg},
          {"tiltDeg", base::radiansToDegrees(all.needs.tiltRad)},
          {"best", all.best ? Json(all.rows[*all.best].cell) : Json()},
          {"reason", base::english(all.reason)},
          {"rows", std::move(rows)}};
}

void say(const Advised& advised) {
  const CellComparison& all = advised.comparison;
  const bool planned = !advised.planned.empty();
  fmt::print("{:<20}{:<20}{:>8}{:>9}{:>11}{:>9}{:>11}{:>8}{}\n", "cell", "form", "reach", "upright",
             "flange kg", "lever mm", "payload kg", "lean", planned ? "  time s  collisions" : "");
  for (std::size_t i = 0; i < all.rows.size(); ++i) {
    const CellAdvice& row = all.rows[i];
    std::string line =
        fmt::format("{:<20}{:<20}{:>7.1f}%{:>8.1f}%{:>11.2f}{:>9.0f}{:>11}{:>8.0f}", row.cell,
                    base::english(cells::traitsOf(row.form).name), 100.0 * row.reach,
                    100.0 * row.uprightReach, row.load.kg, row.load.leverMm,
                    row.load.maxKg ? fmt::format("{:.2f}", *row.load.maxKg) : "-",
                    base::radiansToDegrees(row.leanRad));
    if (planned) {
      const Planned& plan = advised.planned[i];
      line +=
          fmt::format("{:>8}{:>12}  {}", plan.seconds ? fmt::format("{:.0f}", *plan.seconds) : "-",
                      plan.collisions ? std::to_string(*plan.collisions) : "-", plan.verdict);
    }
    if (!row.out.empty())
      line += "  out: " + base::english(row.out);
    fmt::print("{}\n", line);
  }
  fmt::print("{}\n", base::english(all.reason));
}

std::vector<double> tiltsUpTo(double tiltDeg) {
  constexpr double kStepDeg = 30.0;
  std::vector<double> tilts{0.0};
  for (double tilt = kStepDeg; tilt < tiltDeg - 1e-9; tilt += kStepDeg)
    tilts.push_back(tilt);
  if (tiltDeg > 0.0)
    tilts.push_back(tiltDeg);
  return tilts;
}

cells::CellLayout placed(const PlaceCellOptions& options, const base::RunContext& ctx) {
  const robot::RobotModel robot = robot::loadRobot(options.robot);
  if (!robot.kinematics->tilts())
    throw base::Error(base::ErrorCode::Usage,
                      base::message("robot {robot} cannot tilt its flange"_text, robot.id), {},
                      "start from the file of cell t3, t3-wide or five-axis"_text);
  const pipeline::CellNeeds needs = pipeline::cellNeeds(options.request, ctx.sub(0.0, 0.1));
  const process::Process process = process::loadProcess(options.request.choices.tool().process);
  const double tilt = options.tiltDeg.value_or(base::radiansToDegrees(needs.tiltRad));
  cells::LayoutSearch search;
  for (const double degrees : {0.0, 30.0, 45.0, 60.0})
    search.bendsRad.push_back(base::degreesToRadians(degrees));
  search.pattern =
      cells::PosePattern{.radiusMm = std::max({20.0, needs.radiusMm, 0.5 * needs.highMm}),
                         .shells = 6,
                         .sides = 6,
                         .turns = 12,
                         .tiltDeg = tiltsUpTo(tilt)};
  search.part = options.request.item().part;
  return cells::layOut(robot, options.fixed ? robot::Mount::World : robot::Mount::Flange, search,
                       process, ctx.sub(0.1, 1.0));
}

} // namespace

ExitCode cellAdviseCommand(const AdviseOptions& options) {
  const auto advised = endedWith(runInterruptibly(
      [&options](const base::RunContext& ctx) {
        const double share = options.plan ? 0.2 : 1.0;
        Advised all{pipeline::compareCells(options.request, options.cells, ctx.sub(0.0, share)),
                    {}};
        for (std::size_t i = 0; options.plan && i < options.cells.size(); ++i)
          all.planned.push_back(plannedIn(options.request, options.cells[i], ctx.quiet()));
        return all;
      },
      options.threads, {}, [] {}));
  if (!advised)
    return kCancelled;
  if (options.json)
    fmt::print("{}\n", jsonOf(*advised).dump(2, ' ', false, Json::error_handler_t::replace));
  else
    say(*advised);
  return advised->comparison.best ? kDone : kNotAll;
}

ExitCode cellPlaceCommand(const PlaceCellOptions& options) {
  requireNewFile(options.file, options.replace);
  const auto layout = endedWith(
      runInterruptibly([&options](const base::RunContext& ctx) { return placed(options, ctx); },
                       options.threads, {}, [] {}));
  if (!layout)
    return kCancelled;
  robot::CellDescription cell = layout->cell;
  if (!options.file.empty()) {
    cell.id = options.file.stem().string();
    base::writeFile(
        options.file,
        robot::cellFileJson(cell, robot::kindsOf(robot::loadRobot(options.robot).limits)));
  }
  const Eigen::Vector3d nozzle = cell.nozzlePose.linear().col(2);
  const Eigen::Vector3d plate = cell.platePose.translation(), tip = cell.nozzlePose.translation();
  if (options.fixed)
    fmt::print("nozzle at ({:.0f}, {:.0f}, {:.0f}) in the base\n", tip.x(), tip.y(), tip.z());
  else
    fmt::print("nozzle bent by {:.0f} deg, tip ({:.1f}, {:.1f}, {:.1f}) from the flange; plate at "
               "({:.0f}, {:.0f}, {:.0f}) in the base\n",
               base::radiansToDegrees(std::acos(std::min(1.0, std::abs(nozzle.z())))), tip.x(),
               tip.y(), tip.z(), plate.x(), std::round(plate.y()) + 0.0, plate.z());
  fmt::print("{}\n", cell.note);
  for (const std::string& note : layout->notes)
    fmt::print("assumed: {}\n", note);
  if (!options.file.empty())
    fmt::print("cell {} {}\n", cell.id, options.file.string());
  return kDone;
}

} // namespace voluta::cli
