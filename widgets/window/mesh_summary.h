// A loaded part in the words of the mesh panel.
#pragma once

#include "panels/mesh_panel.h"
#include "project/loaded_part.h"

namespace voluta::window {

panels::MeshSummary meshSummary(const project::LoadedPart& part);

} // namespace voluta::window
