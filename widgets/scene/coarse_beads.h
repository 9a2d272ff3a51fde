// Longer segments in place of those of the beads, for fast frames. Private to the module.
#pragma once

#include "plan/tool_plan.h"
#include "scene/drawing_data.h"
#include "scene/mesh_buffers.h"

#include <cstddef>
#include <vector>

namespace voluta::scene {

// Adds the two triangles of a segment between two waypoints.
inline void addBeadSegment(MeshBuffers& buffers, std::size_t from, std::size_t to) {
  const auto a = static_cast<std::int32_t>(2 * from), b = static_cast<std::int32_t>(2 * to);
  buffers.addTriangle(a, a + 1, b);
  buffers.addTriangle(a + 1, b + 1, b);
}

// Adds all levels to a drawing that has the beads themselves. `order`: the paths by layer; `sight`:
// of the segment that ends at each waypoint.
void addCoarseBeads(const plan::ToolPlan& plan, const std::vector<std::size_t>& order,
                    const std::vector<BeadSight>& sight, PathsDrawing& drawing,
                    MeshBuffers& buffers);

} // namespace voluta::scene
