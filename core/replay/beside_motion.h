// What a program does beside going where it was planned to: it waits, it primes, it tells the
// controller how hard to speed up, what the arm carries and where a nozzle stands.
#pragma once

#include "plan/program.h"
#include "plan/tool_plan.h"
#include "process/process.h"
#include "replay/comparison.h"
#include "replay/executed_path.h"
#include "robot/cell.h"

#include <cstddef>
#include <vector>

namespace voluta::replay {

// Returns the first motion that extrudes, program.motions.size() where none does. Not of the
// motions before program.firstMotion, which are no text of its own.
std::size_t firstBeadOf(const plan::ReadProgram& program);

// What the plan has flow out before its first bead: a usual bead's flow for the process' time, at
// most the extruder's full flow. 0 where nothing is printed, and where a bead of its own fills the
// nozzle. `firstPoint`: of the trajectory, where the program begins. mm3.
double plannedPrimeMm3(const plan::ToolPlan& plan, const plan::Trajectory& trajectory,
                       const process::Process& process, std::size_t firstPoint = 0);

// Material that pauses between the first bead and the last let out; it lies in no bead. mm3.
double standingMm3(const plan::ReadProgram& program);

// Findings of pauses, prime, load, nozzle, the first motion's speed and accelerations, each at its
// line.
// - A pause amid the print in which more than 0.005 mm3 flow.
// - Pauses between the first motion and the last that the plan has not, where they come to more
//   than 0.1 s in all: each of them, the first 100. Planned are the prime, and filament that is
//   drawn back and returned, as far as the process has it, at kDrawBackMmPerS or faster.
// - Before the first bead what flows is the prime, within a tenth; languages that have no word for
//   a pause have none.
// - The load is told within a kilogram or a factor of 3 of what is assumed (0.5 kg of plate and
//   the part, or 1 kg of head).
// - A nozzle that stands, where the program says where, is within 0.05 mm of the cell's, its axis
//   within 0.01 rad.
// - The first motion starts from wherever the arm stands: at most 60 degrees/s, 2 rad/s2,
//   250 mm/s (the speed that safety standards have for teaching, ISO 10218-1).
// - A straight motion speeds up at most half as hard again as the process does or as its own
//   speeds ask for; a joint motion as the joints may.
std::vector<TextFinding> judgeBesideMotion(const plan::ReadProgram& program,
                                           const ExecutedPath& path, const plan::ToolPlan& plan,
                                           const plan::Trajectory& trajectory,
                                           const robot::Cell& cell, const process::Process& process,
                                           std::size_t firstPoint = 0);

} // namespace voluta::replay
