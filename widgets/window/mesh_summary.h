// A loaded part in the words of the mesh panel.
#pragma once

#include "panels/mesh_panel.h"
#include "pipeline/load_stage.h"

namespace voluta::window {

panels::MeshSummary meshSummary(const pipeline::LoadedPart& part);

} // namespace voluta::window
