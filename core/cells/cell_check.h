// What a cell cannot do, seen before anything is planned in it.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "collision/cell_collision.h"
#include "process/process.h"
#include "robot/cell.h"

#include <optional>
#include <vector>

namespace voluta::cells {

struct CellFault {
  base::Message what, remedy;
};

// In this order, each where it is so:
// - the nozzle's tip, or the middle of its head, lies in a link or an obstacle at rest;
// - at rest two bodies meet that are to keep apart;
// - nowhere over the plate does the arm bring the nozzle upright to the first layer (25 places, 12
//   turns), or it does, and bodies are always in the way: the pair that is most often, on
//   the ways nearest to rest;
// - what the flange carries, with partKg >= 0 on a plate that the arm holds, is beyond what the
//   robot's maker rates it for.
// A cell that holds a rod is not asked about its plate. Deterministic. Throws Cancelled.
std::vector<CellFault> cellFaults(const robot::Cell& cell, const process::Process& process,
                                  double partKg, const base::RunContext& ctx);

// Of these what keeps the cell from printing anything: the second and the third, with bodies no
// nearer to each other than `margins`. Deterministic. Throws Cancelled.
std::vector<CellFault> printingFaults(const robot::Cell& cell, const process::Process& process,
                                      const collision::Margins& margins,
                                      const base::RunContext& ctx);

// At rest, with the nozzle upright over the middle of the plate: the pose whose bodies are clearest
// of each other, up to 20 mm; of those that are the same to 1 mm the one highest over the plate,
// then the one that turns the joints least. Tried 180, 160 ... 20 mm above it, 16 turns about the
// nozzle, all branches; external axes at 0. None: no such pose has its bodies clear.
std::optional<robot::JointVector> clearestRest(const robot::Cell& cell,
                                               const process::Process& process);

} // namespace voluta::cells
