// A check of about a second before planning: finds plans that cannot succeed because the arm cannot
// move with the chosen head or because no plate is large enough for the part.
#pragma once

#include "base/run_context.h"
#include "modes/mode_stages.h"
#include "plan/finding.h"
#include "project/choices.h"
#include "project/job_stage.h"

#include <memory>
#include <string>

namespace voluta::pipeline {

struct Resolved;

struct StartStage {
  static constexpr project::Stage kStage = project::Stage::Load;
  plan::Findings findings; // of a plan that cannot succeed
};

// Returns the inputs of startStage() as text. They exclude the mode, so that ways of building share
// the result. Throws as startStage().
std::string startKey(const modes::LoadStage& placed, const project::Choices& given,
                     const Resolved& resolved);

// `given`: the item's choices as the user made them; in mode auto the platform may be the user's or
// not. `resolved`: made from them. Returns blocking findings; none if the plan may succeed:
// - CellCannotPrint: two bodies of the cell collide in the home pose, or the head reaches no place
//   above the plate (cells::printingFaults());
// - LargerThanPlates: the part is placed on the cell's plate, or mode auto may choose its platform,
//   and the part's footprint is larger than the largest of the cell's plates, also when turned by a
//   right angle. Checks nothing around a rod, on a body, or on a platform that would float
//   (pedestal.h). Throws Error{Usage} for names and parameters; Cancelled.
std::shared_ptr<const StartStage> startStage(const modes::LoadStage& placed,
                                             const project::Choices& given,
                                             const Resolved& resolved, const base::RunContext& ctx);

} // namespace voluta::pipeline
