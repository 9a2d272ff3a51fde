// Triangulation of the simple solids that make up cells.
#pragma once

#include "robot/body.h"
#include "scene/mesh_buffers.h"

namespace voluta::scene {

// Appends the shape's triangles with normals, in the shape's own frame.
void addShape(MeshBuffers& buffers, const robot::Shape& shape);

} // namespace voluta::scene
