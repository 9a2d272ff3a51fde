// Compares cells for one part and advises one of them (Boge 2019, 6.4 and table 6.7; Castelli 2020,
// 6.6).
//
// Rules, in this order. A cell is out if the part or the body it is printed on is larger than its
// plates, if its flange would carry too much, if its nozzle does not reach the part, or if the head
// is too bulky to lean where it would have to. Of the others a fixed nozzle is preferred: the
// nozzle stays upright, so gravity helps, and its platform may be small. Next a table that tilts
// the part below the nozzle, then a raised plate, which leaves room for a leaning head, then a
// table on the floor. For layers that are all horizontal the nozzle is upright in every cell, so
// that only the fixed nozzle is preferred.
#pragma once

#include "base/run_context.h"
#include "cells/cell_form.h"
#include "cells/flange_load.h"
#include "pipeline/plan_result.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace voluta::pipeline {

// Facts about a part that a cell has to cope with.
struct CellNeeds {
  std::vector<Eigen::Vector2d> foot; // of the part, or of the body below it, on the plate [mm]
  double scale = 1.0;                // at which the foot was taken
  double radiusMm = 0.0, lowMm = 0.0, highMm = 0.0; // of the printed part, above the plate
  double kg = 0.0;                                  // of the part, solid, and of the body below it
  double centreMm = 0.0;                            // of that mass above the plate
  double tiltRad = 0.0;                             // that the layers may need; 0: all horizontal
};

struct CellAdvice {
  std::string cell, label;
  cells::CellForm form = cells::CellForm::RaisedPlate;
  std::optional<double> fitsScale; // of the foot on the largest plate; >= the part's own: it fits
  // Share of the poses of the part, of those at which the head alone is clear of the plate, that
  // are reached without collisions of the cell's bodies; share of the upright ones alone.
  double reach = 0.0, uprightReach = 0.0;
  cells::FlangeLoad load;
  double leanRad = 0.0; // largest angle between nozzle and vertical
  base::Message out;    // why the cell cannot be used; empty if it can
};

struct CellComparison {
  CellNeeds needs;
  std::vector<CellAdvice> rows;    // as asked for
  std::optional<std::size_t> best; // nullopt: no cell can be used
  base::Message reason;            // one sentence
};

// Returns what the part of `request` needs. Density of the first tool's material; a body counts as
// solid, of the same material. Throws Error{Usage, UnreadableFile, UnusableInput}; Cancelled.
CellNeeds cellNeeds(const PlanRequest& request, const base::RunContext& ctx);

// Returns the row of the cell `id`. Throws Error{Usage} for an unknown id; Cancelled.
CellAdvice adviceOn(const std::string& id, const CellNeeds& needs, const process::Process& process,
                    const base::RunContext& ctx);

// Chooses among rows; reason as CellComparison::reason.
CellComparison compared(const CellNeeds& needs, std::vector<CellAdvice> rows);

// Compares the cells with these ids for the request's item, whose own cell does not matter.
// Precondition: at least one id. Throws as cellNeeds() and adviceOn().
CellComparison compareCells(const PlanRequest& request, const std::vector<std::string>& ids,
                            const base::RunContext& ctx);

} // namespace voluta::pipeline
