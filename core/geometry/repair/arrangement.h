// The triangles of a mesh split along their intersections.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <utility>
#include <vector>

namespace voluta::geometry {

// Facets that meet in common edges and vertices only, up to the rounding of vertices to double.
// Facets that lay on each other are one: `layers` counts those facing its way less those facing the
// other way; it is 1 or more, and where it would be 0 the facet is left out.
struct Arrangement {
  TriangleMesh facets; // vertices of equal coordinates are one
  std::vector<int> layers;
};

// `pairs`: selfIntersections() of the mesh. Exact constructions (CGAL). Throws Cancelled.
Arrangement arrange(const TriangleMesh& mesh, const std::vector<std::pair<int, int>>& pairs,
                    const base::RunContext& ctx);

} // namespace voluta::geometry
