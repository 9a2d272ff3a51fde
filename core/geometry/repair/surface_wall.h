// A surface without thickness as a wall of one bead: a thin solid with the surface in its middle.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>

namespace voluta::geometry {

// Thickness of a wall, in the units of the mesh.
struct WallShape {
  double width = 0.0;
  // 0: `width` across the surface everywhere. Otherwise that of level layers of this height: their
  // sections are `width` wide where the surface is steep, and one layer thick where it is shallow.
  double layerHeight = 0.0;
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ(); // normal of the plate

  // Returns the thickness across a surface with this unit normal.
  double across(const Eigen::Vector3d& normal) const;
};

// Returns the solid of this thickness around every open surface and every sheet, united with the
// closed components. Each vertex moves to both sides by the least squares of its triangles' planes,
// parallel to the plate where the surface is steep, so that rims on the plate stay on it. Rims stay
// open; holes narrower than the wall are closed. Unlike thickened(), edges stay sharp and the mesh
// keeps its size. Precondition: width > 0. Throws Error{UnusableInput} if the surface branches, has
// one side only, or crosses itself. Throws Cancelled.
TriangleMesh surfaceWall(const TriangleMesh& mesh, const WallShape& shape,
                         const base::RunContext& ctx);

} // namespace voluta::geometry
