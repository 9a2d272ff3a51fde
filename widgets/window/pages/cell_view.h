// Draws the cell in the view: at home beside the part, or in motion over time.
#pragma once

#include "window/pages/page.h"

namespace voluta::window {

// Adds the chosen cell with its arm at home to a view of the part.
void drawCellAtRest(scene::ViewState& view, const Workspace& work);

// Shows the cell at the time of the time-line, with the beads printed by then. If no motion is
// planned for the chosen cell: that cell at home, with the part or its paths.
void drawCellAtWork(scene::ViewState& view, const Workspace& work);

} // namespace voluta::window
