// The robot at work: what the pages show whose picture is of the whole cell.
#pragma once

#include "window/pages/page.h"

namespace voluta::window {

// The cell at the time of the time-line, with what is printed by then; the part or its paths where
// no motion is planned.
void drawCellAtWork(scene::ViewState& view, const Workspace& work);

} // namespace voluta::window
