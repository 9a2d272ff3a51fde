#include "pipeline/cell_advice.h"

#include "base/error.h"
#include "base/units.h"
#include "cells/best_place.h"
#include "collision/cell_collision.h"
#include "geometry/convex_polygon.h"
#include "geometry/measures.h"
#include "modes/cell_choice.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/cell_plate.h"
#include "pipeline/cell_reach.h"
#include "pipeline/part_size.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"
#include "project/loaded_part.h"
#include "robot/leaning_tool.h"
#include "robot/upright_axes.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace voluta::pipeline {

namespace {

using Eigen::Vector2d;
using Polygon = std::vector<Vector2d>;

constexpr double kEnoughReach = 0.9; // of the poses; tilts of 60 degrees to all sides are seldom
constexpr double kAllUpright = 0.999;
// Lean of the nozzle that a positioner leaves
constexpr double kPositionerLeanRad = base::degreesToRadians(20.0);
// Heads taller than this carry their hopper or pump and are not leant.
constexpr double kBulkyMm = 200.0;

double headMm(const process::Process& process) {
  return process.head.sections.empty() ? 0.0 : process.head.sections.back().zMm;
}

// Returns the largest factor at which the foot, centred and turned by 0 or 90 degrees, is on the
// plate.
double factorOn(const Polygon& foot, const Polygon& plate) {
  const auto factor = [&](bool turned) {
    Eigen::AlignedBox2d box, under;
    for (const Vector2d& p : foot)
      box.extend(p);
    for (const Vector2d& p : plate)
      under.extend(p);
    double maximum = INFINITY;
    for (std::size_t i = 0; i < plate.size(); ++i) {
      const Vector2d side = plate[(i + 1) % plate.size()] - plate[i];
      const Vector2d out = Vector2d(side.y(), -side.x()).normalized();
      double reach = 0.0;
      for (const Vector2d& p : foot) {
        const Vector2d d = p - box.center();
        reach = std::max(reach, out.dot(turned ? Vector2d(-d.y(), d.x()) : d));
      }
      if (reach > 0.0)
        maximum = std::min(maximum, out.dot(plate[i] - under.center()) / reach);
    }
    return maximum;
  };
  return std::max(factor(false), factor(true));
}

cells::ReachGrid gridFor(const robot::Cell& cell, const CellNeeds& needs,
                         const process::Process& process) {
  constexpr double kAcross = 12.0, kRoundMm = 5.0;
  Eigen::AlignedBox2d box;
  for (const Vector2d& corner : largestPlate(cell))
    box.extend(corner);
  cells::ReachGrid grid;
  const double across = box.isEmpty() ? kPlateOfNoneMm : box.sizes().maxCoeff();
  grid.spacingMm = std::max(kRoundMm, kRoundMm * std::round(across / kAcross / kRoundMm));
  const double low = std::max(needs.lowMm, process.layerHeightMm);
  grid.heightsMm = {low};
  for (const double height : {0.5 * (low + needs.highMm), needs.highMm})
    if (height > grid.heightsMm.back() + 1.0)
      grid.heightsMm.push_back(height);
  grid.tiltsRad = {0.0};
  if (needs.tiltRad > 0.0)
    grid.tiltsRad = {0.0, 0.5 * needs.tiltRad, needs.tiltRad};
  grid.azimuths = 8;
  grid.turns = 8;
  grid.axisPlaces = 5;
  return grid;
}

// Returns the share of the map's heights and directions at which the head alone is clear of the
// plate at this point: no arm reaches the others.
double clearOfPlate(const robot::Cell& cell, const process::Process& process,
                    const cells::ReachMap& map, const Vector2d& at) {
  const collision::CellCollision collision(cell, process);
  const cells::ReachGrid& grid = map.grid();
  std::size_t all = 0, clear = 0;
  for (const double height : grid.heightsMm)
    for (const cells::Direction& direction : map.directions()) {
      const Eigen::Isometry3d pose =
          robot::leaningTool({at.x(), at.y(), height}, grid.tiltsRad[direction.tilt],
                             base::kTwoPi * direction.azimuth / grid.azimuths);
      ++all;
      clear += collision.headTouchesPlatform(pose, collision::Margins().headMm) ? 0 : 1;
    }
  return static_cast<double>(clear) / static_cast<double>(std::max<std::size_t>(all, 1));
}

double leanIn(const robot::Cell& cell, const CellNeeds& needs, cells::CellForm form) {
  if (form == cells::CellForm::FixedNozzle || form == cells::CellForm::Rod ||
      robot::tiltsPart(cell) || !cell.tilts())
    return 0.0;
  return form == cells::CellForm::TiltingTable ? std::min(needs.tiltRad, kPositionerLeanRad)
                                               : needs.tiltRad;
}

base::Message whyOut(const CellAdvice& row, const CellNeeds& needs, const robot::Cell& cell,
                     const process::Process& process) {
  if (row.form == cells::CellForm::Rod)
    return "it prints around a rod"_text;
  if (row.fitsScale && *row.fitsScale < needs.scale)
    return base::message(
        "its largest plate is too small for the foot, which fits at scale {scale}"_text,
        base::number(*row.fitsScale));
  if (!row.load.carried())
    return row.load.byCurve
               ? base::message("its flange would carry {kg:.3g} kg at {lever:.0f}, the robot "
                               "carries {most:.3g} kg there"_text,
                               base::number(row.load.kg), base::mm(row.load.leverMm),
                               base::number(*row.load.maxKg))
               : base::message("its flange would carry {kg:.3g} kg, the robot's rating is "
                               "{most:.3g} kg"_text,
                               base::number(row.load.kg), base::number(*row.load.maxKg));
  if (needs.tiltRad > 0.0 && !cell.tilts())
    return "its nozzle cannot tilt"_text;
  if (row.leanRad > 0.0 && headMm(process) > kBulkyMm)
    return "its head is too bulky to lean"_text;
  if (row.uprightReach < kAllUpright)
    return base::message("its nozzle reaches {share:.0f} of the part upright"_text,
                         base::percent(100.0 * row.uprightReach));
  if (row.reach < kEnoughReach)
    return base::message("its nozzle reaches {share:.0f} of the poses up to a tilt of "
                         "{tilt:.0f}"_text,
                         base::percent(100.0 * row.reach),
                         base::degrees(base::radiansToDegrees(needs.tiltRad)));
  return {};
}

// Returns the place of a form in the order of preference.
int orderOf(cells::CellForm form, bool upright) {
  if (form == cells::CellForm::FixedNozzle)
    return 0;
  return upright ? 1 : 1 + static_cast<int>(form);
}

// Why the preferred forms are not taken: the first row of a fixed nozzle.
base::Message withoutFixed(const std::vector<CellAdvice>& rows) {
  const auto fixed = std::ranges::find(rows, cells::CellForm::FixedNozzle, &CellAdvice::form);
  if (fixed == rows.end())
    return "no cell with a fixed nozzle is among them"_text;
  return base::message("{cell} is out: {reason}"_text, fixed->cell, fixed->out);
}

base::Message reasonFor(const CellAdvice& row, const std::vector<CellAdvice>& rows) {
  switch (row.form) {
  case cells::CellForm::FixedNozzle:
    return base::message(
        "{cell}: its fixed nozzle stays upright, so gravity helps; the platform may be small, and "
        "the arm carries plate and part ({kg:.3g} kg)"_text,
        row.cell, base::number(row.load.kg));
  case cells::CellForm::TiltingTable:
    return base::message("{cell}: its table tilts the part, so gravity helps; {fixed}"_text,
                         row.cell, withoutFixed(rows));
  case cells::CellForm::RaisedPlate:
    if (row.leanRad > 0.0)
      return base::message(
          "{cell}: its nozzle moves and takes large parts, and the raised plate stays small for a "
          "leaning head, but gravity does not help at up to {lean:.0f} from vertical; {fixed}"_text,
          row.cell, base::degrees(base::radiansToDegrees(row.leanRad)), withoutFixed(rows));
    return base::message("{cell}: its nozzle moves, always upright, and takes large parts; "
                         "{fixed}"_text,
                         row.cell, withoutFixed(rows));
  case cells::CellForm::TableOnFloor:
  case cells::CellForm::Rod:
    break;
  }
  if (row.leanRad > 0.0)
    return base::message(
        "{cell}: its nozzle moves over a table on the floor and takes large parts, but the "
        "platform "
        "is not small and gravity does not help at up to {lean:.0f} from vertical; {fixed}"_text,
        row.cell, base::degrees(base::radiansToDegrees(row.leanRad)), withoutFixed(rows));
  return base::message("{cell}: its nozzle moves, always upright, over a table on the floor and "
                       "takes large parts; {fixed}"_text,
                       row.cell, withoutFixed(rows));
}

} // namespace

CellNeeds cellNeeds(const PlanRequest& request, const base::RunContext& ctx) {
  const project::Choices manual = resolved(request.choices);
  checkChoices(manual);
  const Resolved own = resolve(manual);
  const auto& [choices, values, process] = own.modeChoices();
  const auto loaded =
      request.item().loaded
          ? request.item().loaded
          : project::loadPart(request.item().part, choices.item().repair, ctx.sub(0.0, 0.3));
  const auto placed = loadStage(*loaded, own, ctx.sub(0.3, 1.0));
  const modes::Mode& mode = modes::findMode(choices.item().mode);
  constexpr double kKgPerMm3 = 1e-6; // at 1 g/cm³
  const double density = kKgPerMm3 * process.material.densityGPerCm3;

  CellNeeds needs;
  const cells::Standing standing = standingOf(*placed->part);
  const Eigen::AlignedBox3d box = geometry::bounds(*placed->part);
  needs.scale = placed->scale;
  needs.radiusMm = standing.radiusMm;
  needs.lowMm = std::max(0.0, box.min().z());
  needs.highMm = standing.heightMm;
  needs.tiltRad = mode.upright ? 0.0 : standing.tiltRad;
  needs.foot = footOf(*placed->part);
  const double part = density * std::abs(geometry::volume(*placed->part));
  double moment = part * box.center().z();
  needs.kg = part;
  if (choices.item().platform.isBody())
    if (const auto body = plannedPlatform(*placed, own).mesh) {
      const Eigen::AlignedBox3d bounds = geometry::bounds(*body);
      const double kg = density * std::abs(geometry::volume(*body));
      needs.kg += kg;
      moment += kg * bounds.center().z();
      Polygon points = needs.foot;
      for (const Eigen::Vector3d& v : body->vertices)
        points.emplace_back(v.head<2>());
      needs.foot = geometry::convexPolygon(std::move(points));
    }
  needs.centreMm = needs.kg > 0.0 ? moment / needs.kg : 0.0;
  return needs;
}

CellAdvice adviceOn(const std::string& id, const CellNeeds& needs, const process::Process& process,
                    const base::RunContext& ctx) {
  project::Choices choices;
  choices.cell = id;
  const robot::Cell any = modes::cellOnAnyPlatform(choices, process);
  CellAdvice row;
  row.cell = any.id();
  row.label = any.label();
  row.form = cells::formOf(any, process);
  row.load = cells::flangeLoad(any, process, needs.kg, needs.centreMm);
  row.leanRad = leanIn(any, needs, row.form);
  if (any.rod()) {
    row.out = whyOut(row, needs, any, process);
    return row;
  }
  if (const Polygon plate = largestPlate(any); !plate.empty() && needs.foot.size() >= 3)
    row.fitsScale = scaleWithin(needs.scale * factorOn(needs.foot, plate));
  const bool tooLarge = row.fitsScale && *row.fitsScale < needs.scale;
  if (!tooLarge) {
    const robot::Cell cell = cellToMap(choices, process);
    const cells::ReachMap map =
        cells::reachMap(cell, process, gridFor(cell, needs, process), {}, ctx);
    const cells::Place place = cells::bestPlace(map, {needs.radiusMm, needs.highMm, needs.tiltRad});
    const double clear = clearOfPlate(cell, process, map, place.at);
    row.reach = clear > 0.0 ? std::min(1.0, place.share / clear) : 0.0;
    row.uprightReach = place.uprightShare;
  }
  row.out = whyOut(row, needs, any, process);
  return row;
}

CellComparison compared(const CellNeeds& needs, std::vector<CellAdvice> rows) {
  base::require(!rows.empty(), "cells to compare");
  CellComparison comparison{needs, std::move(rows), std::nullopt, {}};
  const auto rank = [&](const CellAdvice& row) {
    return std::tuple(orderOf(row.form, needs.tiltRad == 0.0), -std::round(50.0 * row.reach));
  };
  for (std::size_t i = 0; i < comparison.rows.size(); ++i)
    if (comparison.rows[i].out.empty() &&
        (!comparison.best || rank(comparison.rows[i]) < rank(comparison.rows[*comparison.best])))
      comparison.best = i;
  if (comparison.best) {
    comparison.reason = reasonFor(comparison.rows[*comparison.best], comparison.rows);
    return comparison;
  }
  std::vector<base::Message> all;
  for (const CellAdvice& row : comparison.rows)
    all.push_back(base::message("{cell} is out: {reason}"_text, row.cell, row.out));
  comparison.reason = base::message("none of these cells: {reasons}"_text, std::move(all));
  return comparison;
}

CellComparison compareCells(const PlanRequest& request, const std::vector<std::string>& ids,
                            const base::RunContext& ctx) {
  base::require(!ids.empty(), "cells to compare");
  constexpr double kNeedsShare = 0.1;
  const CellNeeds needs = cellNeeds(request, ctx.sub(0.0, kNeedsShare));
  const process::Process process = resolve(request.choices).process();
  std::vector<CellAdvice> rows;
  const auto share = [&](std::size_t i) {
    return kNeedsShare +
           (1.0 - kNeedsShare) * static_cast<double>(i) / static_cast<double>(ids.size());
  };
  for (std::size_t i = 0; i < ids.size(); ++i)
    rows.push_back(adviceOn(ids[i], needs, process, ctx.sub(share(i), share(i + 1))));
  return compared(needs, std::move(rows));
}

} // namespace voluta::pipeline
