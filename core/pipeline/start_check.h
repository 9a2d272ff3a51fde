// Whether a plan can come to anything, seen in about a second before it is made: an arm that cannot
// move with the chosen head, a part that no plate carries.
#pragma once

#include "base/run_context.h"
#include "modes/stages.h"
#include "plan/finding.h"
#include "process/process.h"
#include "project/choices.h"
#include "project/stage.h"

#include <memory>
#include <string>

namespace voluta::pipeline {

struct StartStage {
  static constexpr project::Stage kStage = project::Stage::Load;
  plan::Findings findings; // of a plan that is not worth making
};

// What it is made from, as text. Nothing of a mode, so that ways of building share it. Throws as
// startStage().
std::string startKey(const modes::LoadStage& placed, const project::Choices& choices,
                     const process::Process& process);

// Blocking findings, none where the plan may succeed:
// - CellCannotPrint: at rest two bodies of the cell meet, or the head gets to no place over the
//   plate (cells::printingFaults());
// - LargerThanPlates: the part is to stand on the cell's plate, or mode auto may choose its
//   platform, and its foot is larger than the largest of the cell's plates, turned by a right angle
//   too.
// Nothing is checked around a rod, on a body, or on a platform that would float (pedestal.h).
// Throws Error{Usage}: names, parameters; Cancelled.
std::shared_ptr<const StartStage> startStage(const modes::LoadStage& placed,
                                             const project::Choices& choices,
                                             const process::Process& process,
                                             const base::RunContext& ctx);

} // namespace voluta::pipeline
