// Where the material of primes and purges falls.
#pragma once

#include "plan/program.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "platform/platform_solid.h"
#include "replay/alignment.h"
#include "replay/comparison.h"
#include "replay/planned_events.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace voluta::replay {

// What a drop can meet, in the work frame [mm]; a box may be empty.
struct DropTargets {
  Eigen::AlignedBox3d print;     // all beads but primes and skirts
  Eigen::AlignedBox3d workpiece; // a rod or body on which is printed
  Eigen::AlignedBox3d plate;
};
DropTargets dropTargets(const plan::ToolPlan& plan, const platform::PlatformSolid& platform);

// Material flows out at rest before the first bead, or where a purge is planned, and falls from the
// nozzle straight down; the robot's base is upright. Returns a finding, at its line, for each that
// falls within 5 mm of the print's or the workpiece's box (PurgeOnPart), and for each that falls
// on the plate otherwise (PurgeOnPlate). The arm is where the trajectory has it before the point
// that the program's next motion leads to; before the program's first motion, at its start,
// `firstPoint`. Shots, which fill pockets, are no purges.
std::vector<TextFinding> purgeDrops(const plan::ReadProgram& program,
                                    const plan::Trajectory& trajectory, const Alignment& alignment,
                                    const PlannedStops& planned, const DropTargets& targets,
                                    const robot::Cell& cell, std::size_t firstPoint);

} // namespace voluta::replay
