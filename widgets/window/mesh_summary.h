// Describes a loaded part for the mesh panel.
#pragma once

#include "panels/mesh_panel.h"
#include "project/loaded_part.h"

namespace voluta::window {

// `volumeMm3`: of the part as placed and scaled.
panels::MeshSummary meshSummary(const project::LoadedPart& part, double volumeMm3);

} // namespace voluta::window
