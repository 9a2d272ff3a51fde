// Hashes of contents: equal contents, equal hashes.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"

#include <string>
#include <string_view>

namespace voluta::project {

// Returns 16 hexadecimal digits (FNV-1a, 64 bits; not safe against deliberate collisions).
std::string contentHash(std::string_view bytes);
// Hashes the vertices, the triangles and their counts.
std::string contentHash(const geometry::TriangleMesh& mesh);

// Hashes all arrays.
std::string contentHash(const plan::ToolPlan& toolPlan);

} // namespace voluta::project
