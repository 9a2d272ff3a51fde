// Checks of a program's statements besides its path: pauses, prime, accelerations, payload, and the
// pose of a stationary nozzle.
#pragma once

#include "plan/program.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "replay/comparison.h"
#include "replay/executed_path.h"
#include "replay/planned_events.h"
#include "robot/cell.h"

#include <cstddef>
#include <vector>

namespace voluta::replay {

// Returns the first motion that extrudes, or program.motions.size() if there is none. Motions
// before program.firstMotion are ignored: they are not in the text.
std::size_t firstBeadOf(const plan::ReadProgram& program);

// Returns the planned volume extruded before the first bead [mm3]: the flow of a standard bead
// times the process's prime time, limited by the extruder's maximum flow. Returns 0 if nothing is
// printed, or if a prime path or a purge fills the nozzle. `process`: of the tool that is selected
// at `firstPoint`, the point of the trajectory at which the program begins.
double plannedPrimeMm3(const plan::ToolPlan& plan, const plan::Trajectory& trajectory,
                       const process::Process& process, std::size_t firstPoint = 0);

// Returns the material extruded during pauses between the first bead and the last [mm3], without
// planned purges; it is part of no bead.
double standingMm3(const plan::ReadProgram& program, const PlannedStops& planned);

// Returns findings about pauses, prime, load, nozzle, the first motion's speed and accelerations,
// each with its line:
// - a pause during the print in which more than 0.005 mm3 flow;
// - unplanned pauses between the first motion and the last if they exceed 0.1 s in total: one
//   finding per pause, at most 100. Planned pauses are the prime and the retraction and return of
//   filament, up to the process's length, at kDrawBackMmPerS or faster;
// - volume extruded before the first bead that differs from the planned prime by more than a tenth;
//   not for languages that cannot express a pause;
// - a load that differs from the assumed one (0.5 kg of plate plus the part, or 1 kg of head) by
//   more than 1 kg and by more than a factor of 3; its centre of mass, where it is stated, by more
//   than 50 mm;
// - a stationary nozzle whose stated pose differs from the cell's by more than 0.05 mm, or its axis
//   by more than 0.01 rad;
// - a first motion, which starts from any pose of the arm, faster than 60 degrees/s, 2 rad/s2 or
//   250 mm/s (the speed limit of safety standards for teaching, ISO 10218-1);
// - a straight motion whose acceleration is more than 1.5 times the process's acceleration or the
//   one its own speeds require; a joint motion whose acceleration is more than 1.5 times the
//   joints' limit.
// `planned`: waits and purges, which planned_events.h compares.
std::vector<TextFinding> judgeBesideMotion(const plan::ReadProgram& program,
                                           const ExecutedPath& path, const plan::ToolPlan& plan,
                                           const plan::Trajectory& trajectory,
                                           const robot::Cell& cell, const process::Tooling& tooling,
                                           std::size_t firstPoint = 0,
                                           const PlannedStops& planned = {});

} // namespace voluta::replay
