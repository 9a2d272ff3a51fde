// Which beads and travel moves a view shows.
#pragma once

#include "scene/drawing_data.h"
#include "scene/view_state.h"

#include <vector>

namespace voluta::scene {

// Triangles of the beads. What is hidden inside the beads shown is left out, unless a section
// lays it open.
std::vector<Stretch> visibleBeads(const PathsDrawing& paths, const ViewState& view);
// Lines of the travel moves.
std::vector<Stretch> visibleTravels(const PathsDrawing& paths, const ViewState& view);

} // namespace voluta::scene
