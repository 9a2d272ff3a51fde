// The machine in the picture: at rest beside the part, or at work over time.
#pragma once

#include "window/pages/page.h"

namespace voluta::window {

// Adds the chosen cell with its arm at home to a picture of the part.
void drawCellAtRest(scene::ViewState& view, const Workspace& work);

// Shows the cell at the time of the time-line, with what is printed by then. Where no motion is
// planned for the chosen cell: that cell at home, with the part or its paths.
void drawCellAtWork(scene::ViewState& view, const Workspace& work);

} // namespace voluta::window
