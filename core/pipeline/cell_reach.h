// The reach of the cell that was chosen, and of a part in it.
#pragma once

#include "base/run_context.h"
#include "cells/best_place.h"
#include "cells/reach_map.h"
#include "geometry/triangle_mesh.h"
#include "process/process.h"
#include "project/choices.h"

#include <string>

namespace voluta::pipeline {

inline constexpr double kPlateOfNoneMm = 200.0; // disc, in a cell that comes without plates
// Build directions that are asked for where nothing says which a part needs.
inline constexpr double kMappedTiltRad = 1.0471975511965976; // 60 degrees

// The chosen cell with the plate that is mapped: the choices' own where it is one of a fixed size,
// else the largest of the cell's; without any a disc of 200 mm. Throws as robot::loadCell().
robot::Cell cellToMap(const project::Choices& choices, const process::Process& process);

// The cell's map from the first layer up to heightMm, tilts up to kMappedTiltRad, with the
// clearances that a motion keeps. Throws Error{Usage}: names, parameters, no plate; Cancelled.
cells::ReachMap cellReach(const project::Choices& choices, double heightMm,
                          const base::RunContext& ctx);
// What it is made from, as text. Throws as cellReach().
std::string cellReachKey(const project::Choices& choices, double heightMm);

// A part (placed, mm, not empty) as a cylinder about the middle of its bounding box, and where that
// stands.
cells::Standing standingOf(const geometry::TriangleMesh& part);
Eigen::Vector2d middleOf(const geometry::TriangleMesh& part);

} // namespace voluta::pipeline
