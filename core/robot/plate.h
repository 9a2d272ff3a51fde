// The plate of a cell's platform, and whether it stands on what carries it.
#pragma once

#include "robot/body.h"
#include "robot/cell.h"

#include <optional>
#include <vector>

namespace voluta::robot {

// nullptr: the platform is no plate.
const Prism* plateOf(const Cell& cell);

// What joins a plate that lies beside its stem to it: the lower half of the plate's thickness, as
// far as both. Nothing where they meet, and without a stem (frusta among the shapes, one of them up
// to the plate's underside).
std::optional<Prism> footOf(const Prism& plate, const std::vector<Shape>& shapes);

// The foot that the cell's platform has. nullptr: it needs none.
const Prism* footOf(const Cell& cell);

// How far the plate, without its foot, lies beside the top of its stem, mm; 0 where they meet, and
// in a cell without a stem.
double platformGapMm(const Cell& cell);

} // namespace voluta::robot
