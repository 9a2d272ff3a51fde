// The platform's solid in a cell's file: the plate and its stem, or the rod. Keys:
// robot/cell/cell_reader.cpp.
#pragma once

#include "base/json_node.h"
#include "platform/platform_solid.h"
#include "robot/body.h"
#include "robot/cell.h"
#include "robot/cell/external_axis.h"

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace voluta::robot {

// All throw Error{UnusableInput} naming file and key.

CellRod readRod(const base::JsonNode& node);

// Throws where `chain`, read from `axes`, is not one axis that turns a rod along the work frame's
// x about itself.
void requireTurnsRod(const base::JsonNode& axes, const std::vector<ExternalAxis>& chain,
                     const Eigen::Isometry3d& axis_T_work);

// Returns the body of the rod that is in the cell: `wanted`, the job's, where there is one; else a
// straight one as the cell's. Throws where `cell` (its id) has no room for it.
Body rodBody(const CellRod& own, const std::optional<platform::RodShape>& wanted,
             const std::string& cell, int workFrame);

// Returns the body of the plate with its stem and foot. Precondition: `polygon` is convex and
// counter-clockwise.
Body plateBody(const base::JsonNode& platform, std::vector<Eigen::Vector2d> polygon, int workFrame);

} // namespace voluta::robot
