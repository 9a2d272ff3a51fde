// Suggests a cell with a larger plate than the chosen one.
#pragma once

#include "project/choices.h"

#include <Eigen/Core>
#include <optional>
#include <string>

namespace voluta::pipeline {

// Returns the id of the cell whose largest plate is the smallest one that is longer than that of
// the chosen cell and carries a foot of that size, rotated by 0 or 90 degrees; the first of equals.
// Prefers cells that move the nozzle or the plate as the chosen one does. Returns nullopt if there
// is none, or if the mode prints around a rod. Throws Error{Usage} for an unknown cell or process.
std::optional<std::string> cellWithLargerPlate(const project::Choices& choices,
                                               const Eigen::Vector2d& footMm);

} // namespace voluta::pipeline
