// Planes where regions of a surface meet.
#pragma once

#include "geometry/triangle_mesh.h"
#include "planar/plane.h"
#include "planar/published/surface_regions.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// One stretch of the border of two regions, and the plane through it. mm.
struct RegionPlane {
  int from = 0, to = 0;             // regions; the plane's normal looks to `to`
  Plane plane;                      // through the middle of the stretch
  std::vector<Eigen::Vector3d> rim; // middles of its edges
  Eigen::Vector3d behind, beyond;   // points on the surface of `from` and of `to`, near the stretch
};

// Each stretch's plane by principal components of its edges' middles and these set off along the
// surface's normals to both sides by 1 % of the mesh's diagonal (RoboFDM, phase I): least squares,
// and across the surface where the stretch alone does not tell. By pairs of regions from < to,
// stretches of a pair in order of their least vertex; those of fewer than three edges are left out.
std::vector<RegionPlane> regionPlanes(const geometry::TriangleMesh& mesh,
                                      const SurfaceRegions& regions);

// The same plane, seen from `to`.
RegionPlane reversed(RegionPlane plane);

} // namespace voluta::planar
