// Triangles of the simple solids that cells are made of.
#pragma once

#include "robot/body.h"
#include "scene/mesh_buffers.h"

namespace voluta::scene {

// With normals, in the shape's own frame.
void addShape(MeshBuffers& buffers, const robot::Shape& shape);

} // namespace voluta::scene
