// The reach map of the chosen cell, and the cylinder that stands for a part in it.
#pragma once

#include "base/run_context.h"
#include "cells/best_place.h"
#include "cells/reach_map.h"
#include "geometry/triangle_mesh.h"
#include "process/process.h"
#include "project/choices.h"

#include <string>

namespace voluta::pipeline {

struct Resolved;

// Diameter of the disc used for cells without plates
inline constexpr double kPlateOfNoneMm = 200.0;
// Maximum tilt of the build directions that are mapped when the part's own tilt is unknown.
inline constexpr double kMappedTiltRad = 1.0471975511965976; // 60 degrees

// Returns the chosen cell with the plate that is mapped: the plate of the choices if it has a fixed
// size, else the cell's largest plate, or a disc of 200 mm if the cell has none. Throws as
// robot::loadCell().
robot::Cell cellToMap(const project::Choices& choices, const process::Process& process);

// Returns the cell's reach map from the first layer up to heightMm, for tilts up to kMappedTiltRad,
// with the clearances that motion planning keeps. Throws Error{Usage} for invalid names and
// parameters and for a missing plate; throws Cancelled.
cells::ReachMap cellReach(const Resolved& resolved, double heightMm, const base::RunContext& ctx);
// Returns the cache key of cellReach(). Throws as cellReach().
std::string cellReachKey(const Resolved& resolved, double heightMm);

// Return a part (placed, [mm], not empty) as a cylinder about the centre of its bounding box, and
// that centre.
cells::Standing standingOf(const geometry::TriangleMesh& part);
Eigen::Vector2d middleOf(const geometry::TriangleMesh& part);

} // namespace voluta::pipeline
