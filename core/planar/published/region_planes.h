// Planes along the borders of a surface's regions.
#pragma once

#include "geometry/triangle_mesh.h"
#include "planar/plane.h"
#include "planar/published/surface_regions.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// One stretch of the border of two regions, and the plane through it [mm].
struct RegionPlane {
  int from = 0, to = 0;             // regions; the plane's normal points to `to`
  Plane plane;                      // through the centroid of the stretch
  std::vector<Eigen::Vector3d> rim; // midpoints of its edges
  Eigen::Vector3d behind, beyond;   // points on the surface of `from` and of `to`, near the stretch
};

// Computes each stretch's plane by principal component analysis of its edges' midpoints and of
// these points displaced along the surface's normals to both sides by 1 % of the mesh's diagonal
// (RoboFDM, phase I): least squares, and perpendicular to the surface if the stretch alone does not
// determine the plane. Sorted by pairs of regions from < to; stretches of a pair in order of their
// lowest vertex. Stretches of fewer than three edges are left out.
std::vector<RegionPlane> regionPlanes(const geometry::TriangleMesh& mesh,
                                      const SurfaceRegions& regions);

// Returns the same plane, seen from `to`.
RegionPlane reversed(RegionPlane plane);

} // namespace voluta::planar
