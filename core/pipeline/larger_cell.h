// A cell with more room than the one that was chosen.
#pragma once

#include "project/choices.h"

#include <Eigen/Core>
#include <optional>
#include <string>

namespace voluta::pipeline {

// Returns the id of the cell whose largest plate is the smallest one that is longer than that of
// the chosen cell and carries a foot of that size, turned by a right angle or not; of equals the
// first. It moves the nozzle or the plate as the chosen one does where there is such a cell.
// nullopt: there is none, or the mode prints around a rod. Throws Error{Usage} for a cell or a
// process that nothing answers to.
std::optional<std::string> cellWithLargerPlate(const project::Choices& choices,
                                               const Eigen::Vector2d& footMm);

} // namespace voluta::pipeline
