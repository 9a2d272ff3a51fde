// Tool-paths that were loaded with the part (project::LoadedPart::toolPaths) and replace planned
// layers.
#pragma once

#include "base/parameters.h"
#include "base/text.h"
#include "geometry/placement.h"
#include "plan/finding.h"
#include "project/choices.h"

#include <memory>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}
namespace voluta::geometry {
struct TriangleMesh;
}
namespace voluta::modes {
struct DecomposeStage;
struct LayersStage;
struct LoadStage;
} // namespace voluta::modes
namespace voluta::plan {
struct ToolPlan;
}
namespace voluta::process {
class Tooling;
}
namespace voluta::project {
struct LoadedPart;
}

namespace voluta::pipeline {

struct ToolpathStage;

// Returns whether the part is printed along the tool-paths of its file. The mode then only
// determines the platform.
bool takesGivenPaths(const project::LoadedPart& loaded, const base::ParameterValues& values);

// Returns the choices for such a part if the way of building is automatic: on the cell's plate, or
// around its rod. Returns other choices unchanged. Throws Error{Usage} if no way applies.
project::Choices choicesForGivenPaths(project::Choices choices);

// Returns the default placement of such a part: that of the file if it is in the work frame;
// nullopt if the part is placed as others are.
std::optional<geometry::Placement> givenPlacement(const project::LoadedPart& loaded);

// Returns a sentence about tools of the file that the job does not have; empty: it has all.
std::vector<base::Message> missingToolNotes(const plan::ToolPlan& given,
                                            const process::Tooling& tooling);

// Returns the kind of finding of the same fact whose remedies are for tool-paths that were not
// planned; `kind` itself if its remedies are for all.
plan::FindingKind kindForGiven(plan::FindingKind kind);

// Returns a finding if the tool-paths have more than 1 % less or more material than the E words of
// their file; none if the file has no such amounts.
plan::Findings amountFindings(const project::LoadedPart& loaded);

// Returns findings with remedies for tool-paths that were not planned: turning or scaling the part,
// or choosing another way of building, does not change them. `isGiven`: of each item; findings
// of no item are changed if all of them are. Precondition: findings name items of the job or none.
plan::Findings withRemediesForGiven(plan::Findings findings, const std::vector<bool>& isGiven);

// Throws Error{Usage} if the scale or unit of the choices would change the size of the beads.
void requireOwnSize(const project::Choices& choices);

// Returns the stage with only the mode's platform, result kind and timings. Findings and report are
// omitted because they describe layers that are not made. `body`: made for the paths, becomes the
// platform's; null: none.
std::shared_ptr<const modes::DecomposeStage>
onlyGround(const modes::DecomposeStage& made, std::shared_ptr<const geometry::TriangleMesh> body);
// Returns a stage without layers; its report counts the layers of the tool-paths.
std::shared_ptr<const modes::LayersStage> layersOfGiven(const plan::ToolPlan& given);

// Returns the tool-paths transformed to the pose of `placed`. Waypoints are at most a step of the
// process apart (1.5 steps count as one), missing sections and speeds are taken from the process,
// and speeds are limited to the extruder's maximum flow. The file's tool T n is the job's tool n +
// 1, with its process; the first tool prints the beads of tools that the job does not have.
// Findings report missing values, speeds, and beads outside the limits of their process. Throws
// Cancelled.
std::shared_ptr<const ToolpathStage> givenToolpathStage(const project::LoadedPart& loaded,
                                                        const modes::LoadStage& placed,
                                                        const process::Tooling& tooling,
                                                        const base::RunContext& ctx);

} // namespace voluta::pipeline
