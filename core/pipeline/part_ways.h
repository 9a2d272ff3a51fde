// How a placed part could stand otherwise, and whether it should.
#pragma once

#include "base/run_context.h"
#include "geometry/placement.h"
#include "modes/stages.h"
#include "placement/ways_to_stand.h"
#include "plan/finding.h"
#include "process/process.h"
#include "project/choices.h"
#include "project/loaded_part.h"
#include "project/stage.h"

#include <string>
#include <vector>

namespace voluta::pipeline {

// Is it for the user to say how the part stands? Some modes lay it themselves.
bool standsFreely(const project::Choices& choices);

// placement::waysToStand() of the part as it was placed; of a voxel object quarter turns only.
// Throws Error{Usage}: a parameter, the part's size; Cancelled.
std::vector<placement::Way> partWays(const modes::LoadStage& placed,
                                     const project::Choices& choices,
                                     const process::Process& process, const base::RunContext& ctx);
// What they are made from, as text, but for how the part is turned. `scale`: of the placed part.
std::string partWaysKey(const project::LoadedPart& loaded, double scale,
                        const project::Choices& choices, const process::Process& process);

// The placement that stands the part so, on the plate. `placed`: with which the way was found.
geometry::Placement standing(const placement::Way& way, const geometry::Placement& placed);

// Where a part lies badly (placement::liesBadly): told, with the way that is best.
struct StandStage {
  static constexpr project::Stage kStage = project::Stage::Load;
  plan::Findings findings;
};
// What it is made from, as text: nothing of a platform, so that ways of building share it.
std::string standKey(const project::LoadedPart& loaded, const modes::LoadStage& placed,
                     const project::Choices& choices, const process::Process& process);
// Nothing is told of parts that the mode or a search (orient) lays. Throws as partWays().
std::shared_ptr<const StandStage> standStage(const modes::LoadStage& placed,
                                             const project::Choices& choices,
                                             const process::Process& process,
                                             const base::RunContext& ctx);

} // namespace voluta::pipeline
