// Splits the triangles of a mesh along their intersections.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <utility>
#include <vector>

namespace voluta::geometry {

// Facets that share only common edges and vertices, up to the rounding of vertices to double.
// Coincident facets are merged: `layers` counts those in the facet's direction minus those in the
// opposite direction; it is at least 1, and facets for which it would be 0 are left out.
struct Arrangement {
  TriangleMesh facets; // vertices of equal coordinates are merged
  std::vector<int> layers;
};

// `pairs`: selfIntersections() of the mesh. Exact constructions (CGAL). Throws Cancelled.
Arrangement arrange(const TriangleMesh& mesh, const std::vector<std::pair<int, int>>& pairs,
                    const base::RunContext& ctx);

} // namespace voluta::geometry
