// Checks of a cell before anything is planned in it.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "collision/margins.h"
#include "process/process.h"
#include "robot/cell.h"

#include <optional>
#include <vector>

namespace voluta::cells {

struct CellFault {
  base::Message what, remedy;
};

// Returns the faults found, in this order:
// - the head seems to be upside down (process::upsideDown);
// - the nozzle's tip, or the middle of its head, is inside a link or an obstacle in the home pose;
// - two bodies that must keep apart collide in the home pose;
// - the arm cannot bring the nozzle upright to the first layer anywhere over the plate (25 places,
//   12 turns), or it always collides there: the most frequent pair, for the solutions nearest to
//   the home pose;
// - the arm cannot bring the nozzle, pointing down, to the cell's place for purges, or always
//   collides there;
// - the flange's payload (with partKg >= 0 on a plate held by the arm) exceeds the robot's rating.
//
// Cells with a rod skip the check of the plate. Deterministic. Throws Cancelled.
std::vector<CellFault> cellFaults(const robot::Cell& cell, const process::Process& process,
                                  double partKg, const base::RunContext& ctx);

// Returns only the faults that prevent all printing: the third and the fourth, with a minimum
// distance of bodies of `margins`. Deterministic. Throws Cancelled.
std::vector<CellFault> printingFaults(const robot::Cell& cell, const process::Process& process,
                                      const collision::Margins& margins,
                                      const base::RunContext& ctx);

// Returns the best home pose with the nozzle upright over the middle of the plate: the one with the
// largest clearance between bodies, up to 20 mm; among equal ones (to 1 mm) the highest above the
// plate, then the one with the smallest joint values. Tries 180, 160 ... 20 mm above the plate, 16
// turns about the nozzle, and all IK branches; external axes at 0. Returns nullopt if no such pose
// is free of collisions.
std::optional<robot::JointVector> clearestRest(const robot::Cell& cell,
                                               const process::Process& process);

} // namespace voluta::cells
