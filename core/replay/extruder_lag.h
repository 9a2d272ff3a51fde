// The material of extruders that lag behind their command (process::ExtruderLag).
#pragma once

#include "plan/program.h"
#include "plan/trajectory.h"
#include "process/tooling.h"
#include "replay/alignment.h"
#include "replay/executed_path.h"

namespace voluta::replay {

// Sets when material flows instead of when the extruder is commanded to. Material begins to flow a
// start lag after the extruder is switched on, pauses before the bead included, and ends a stop lag
// after it is switched off. The motions after the command have the section of the bead before it
// (ProgramMotion::trailing). Each motion flows wholly or not at all: the planned end of a bead
// counts as its end if that differs by no more than half a motion, at most 0.4 stop lags, or
// 0.05 s. Without lags the program remains unchanged. `path`, `alignment`: those of the program.
void followLags(plan::ReadProgram& program, const ExecutedPath& path,
                const plan::Trajectory& trajectory, const Alignment& alignment,
                const process::Tooling& tooling);

} // namespace voluta::replay
