// The plate of a cell's platform, and the foot that joins it to its stem.
#pragma once

#include "robot/body.h"
#include "robot/cell.h"

#include <optional>
#include <vector>

namespace voluta::robot {

// Returns nullptr if the platform is not a plate.
const Prism* plateOf(const Cell& cell);

// Returns the foot that joins a plate to a stem beside it: the lower half of the plate's thickness,
// extended over both. Returns nullopt if plate and stem touch, or there is no stem (a frustum of
// `shapes` that ends at the plate's underside).
std::optional<Prism> footOf(const Prism& plate, const std::vector<Shape>& shapes);

// Returns the foot of the cell's platform; nullptr if it needs none.
const Prism* footOf(const Cell& cell);

// Returns the lateral distance [mm] of the plate, without its foot, from the top of its stem; 0 if
// they touch or the cell has no stem.
double platformGapMm(const Cell& cell);

} // namespace voluta::robot
