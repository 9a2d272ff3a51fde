// Tool-paths that came with the part (project::LoadedPart::toolPaths) instead of layers of our own.
#pragma once

#include "base/parameters.h"
#include "geometry/placement.h"
#include "modes/stages.h"
#include "pipeline/stages.h"
#include "process/process.h"
#include "project/choices.h"
#include "project/loaded_part.h"

#include <memory>
#include <optional>

namespace voluta::pipeline {

// Is the part printed along the tool-paths that it brings? The mode then says only what material
// starts on.
bool takesGivenPaths(const project::LoadedPart& loaded, const base::ParameterValues& values);

// The choices for such a part where the way of building is looked for: on the cell's plate, or
// around its rod. Others as they are. Throws Error{Usage}: there is none.
project::Choices choicesForGivenPaths(project::Choices choices);

// Where such a part lies unless the user has placed it: where the file says, if that is in the work
// frame; none: as others.
std::optional<geometry::Placement> givenPlacement(const project::LoadedPart& loaded);

// Throws Error{Usage}: a scale or a unit by which beads would be another size.
void requireOwnSize(const project::Choices& choices);

// Of the mode's result what such a part needs: what it starts on. Findings and report are left out,
// since they are about layers that are not made.
std::shared_ptr<const modes::DecomposeStage> onlyGround(const modes::DecomposeStage& made);
// No layers; the report counts those of the tool-paths.
std::shared_ptr<const modes::LayersStage> layersOfGiven(const plan::ToolPlan& given);

// The tool-paths where `placed` has the part, with waypoints no further apart than the process's
// step, sections and speeds of the process where the file gives none, and no more flow than its
// extruder gives; the last two are told. Throws Cancelled.
std::shared_ptr<const ToolpathStage> givenToolpathStage(const project::LoadedPart& loaded,
                                                        const modes::LoadStage& placed,
                                                        const process::Process& process,
                                                        const base::RunContext& ctx);

} // namespace voluta::pipeline
