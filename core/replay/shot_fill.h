// The material of a shot into a pocket, on the grid of a depositor.
#pragma once

#include "replay/depositor.h"

#include <cstdint>

namespace voluta::replay {

// Fills the room that a shot reaches from the nozzle's tip with its volume, the deepest cells
// first: cells below the tip that are joined to it by cells less than half full, no deeper than the
// pocket's height (the piece's height) and no further aside than a fluid would flow (1.5 times the
// cube root of the volume). Such cells and their neighbours are filled up. Returns the volume that
// found no room, in cell volumes. `piece`: its index.
double fillFromTip(BeadGrid& grid, const BeadPiece& shot, std::uint32_t piece);

} // namespace voluta::replay
