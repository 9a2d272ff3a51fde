// Selection of the beads and travel moves that a view shows.
#pragma once

#include "scene/drawing_data.h"
#include "scene/view_state.h"

#include <vector>

namespace voluta::scene {

struct VisibleBeads {
  std::vector<Stretch> stretches;
  int everyLayer = 1; // only every so many layers are drawn, so much higher
};

// Returns the triangles of the beads, without those hidden inside other beads unless a section
// exposes them. While dragging, the finest level of detail that is not more than the view allows.
VisibleBeads visibleBeads(const PathsDrawing& paths, const ViewState& view);
// Returns the lines of the travel moves.
std::vector<Stretch> visibleTravels(const PathsDrawing& paths, const ViewState& view);

} // namespace voluta::scene
