// Alternative orientations of a placed part, and whether one of them should be used.
#pragma once

#include "base/run_context.h"
#include "geometry/placement.h"
#include "modes/mode_stages.h"
#include "placement/ways_to_stand.h"
#include "plan/finding.h"
#include "project/choices.h"
#include "project/job_stage.h"
#include "project/loaded_part.h"

#include <string>
#include <vector>

namespace voluta::pipeline {

struct Resolved;

// Returns whether the user chooses the part's orientation. Some modes place the part themselves.
bool standsFreely(const project::Choices& choices);

// Returns placement::waysToStand() of the part as placed; for a voxel object only quarter turns.
// Throws Error{Usage} for parameters or the part's size; Cancelled.
std::vector<placement::StandingOrientation>
partWays(const modes::LoadStage& placed, const Resolved& resolved, const base::RunContext& ctx);
// Returns a rough printing time of the part in that orientation [s], with the walls, the infill and
// the least layer time of the choices (placement::estimatedSeconds). Throws Error{Usage}.
double estimatedSeconds(const placement::StandingOrientation& orientation,
                        const Resolved& resolved);
// Cache key: all inputs of partWays() except the part's rotation. `scale` is that of the placed
// part.
std::string partWaysKey(const project::LoadedPart& loaded, double scale, const Resolved& resolved);

// Returns the placement that puts the part on the plate in this orientation. `placed`: the
// placement from which the way was computed.
geometry::Placement standing(const placement::StandingOrientation& orientation,
                             const geometry::Placement& placed);

// Findings of poor orientation (placement::liesBadly), with the best alternative.
struct StandStage {
  static constexpr project::Stage kStage = project::Stage::Load;
  plan::Findings findings;
};
// Cache key of the StandStage. It does not depend on the platform, so that ways of building share
// the result.
std::string standKey(const project::LoadedPart& loaded, const modes::LoadStage& placed,
                     const Resolved& resolved);
// Returns no findings for parts that the mode or a search (orient) orients. Throws as partWays().
std::shared_ptr<const StandStage> standStage(const modes::LoadStage& placed,
                                             const Resolved& resolved, const base::RunContext& ctx);

} // namespace voluta::pipeline
