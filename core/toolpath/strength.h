// Figures of the printed part under a load in one direction.
#pragma once

#include "layers/layer_stack.h"
#include "plan/statistics.h"
#include "plan/tool_plan.h"

#include <Eigen/Core>
#include <optional>
#include <string>

namespace voluta::toolpath {

// Parses the direction of a load, "x,y,z". Returns a unit vector; nullopt for an empty text. Throws
// Error{Usage} naming the parameter loadDirection.
std::optional<Eigen::Vector3d> loadDirection(const std::string& text);

// Returns the figures of one item; all 0 if it has no layers. Interfaces are between layers: none
// is below the first layer. Prime, skirts, supports, tapes and shots are not part of the figures. `load`:
// a unit vector, work frame.
plan::StrengthStatistics strengthOf(const layers::LayerStack& stack, const plan::ToolPlan& plan,
                                    int item, const Eigen::Vector3d& load);

} // namespace voluta::toolpath
