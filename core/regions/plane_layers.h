// Layers of a region in planes: along a direction, or turning from one direction to another.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "substrate/level_stack.h"

#include <Eigen/Core>

namespace voluta::regions {

// Returns layers perpendicular to the unit direction, of equal height (planar::layerBounds()). Each
// is the section of the solid at half its height. Sections too small for a bead are left out, which
// a finding reports. Throws Cancelled.
substrate::StackedLevels flatLayers(const geometry::TriangleMesh& solid,
                                    const Eigen::Vector3d& direction,
                                    const substrate::LevelOptions& levels,
                                    const base::RunContext& ctx);

// Returns layers between two planes: a horizontal one below the solid, and one above it,
// perpendicular to the unit direction. They turn about the line in which these planes meet, so that
// their thickness grows with the distance from it (RoboFDM and Castelli 2020, 1.3.1, turn at once).
// Their number keeps all thicknesses within the limits. Throws Error{UnusableInput} if no number
// does, or the line passes through the solid; Cancelled. Precondition: the direction is not z.
substrate::StackedLevels turningLayers(const geometry::TriangleMesh& solid,
                                       const Eigen::Vector3d& direction,
                                       const substrate::LevelOptions& levels,
                                       const base::RunContext& ctx);

} // namespace voluta::regions
