// Names content by itself: equal bytes, equal name.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"

#include <string>
#include <string_view>

namespace voluta::project {

// 16 hexadecimal digits (FNV-1a, 64 bits; no protection against who means harm).
std::string contentHash(std::string_view bytes);
// Of vertices and triangles, and how many there are.
std::string contentHash(const geometry::TriangleMesh& mesh);

// Of all its arrays.
std::string contentHash(const plan::ToolPlan& toolPlan);

} // namespace voluta::project
