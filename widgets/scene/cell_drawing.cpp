#include "scene/drawing_data.h"
#include "scene/shape_mesh.h"

namespace voluta::scene {

std::shared_ptr<const CellDrawing> drawCell(const robot::Cell& cell) {
  auto drawing = std::make_shared<CellDrawing>(CellDrawing{cell, {}});
  for (const robot::Body& body : cell.bodies()) {
    MeshBuffers buffers;
    for (const robot::Shape& shape : body.shapes)
      addShape(buffers, shape);
    drawing->bodies.push_back(polyDataOf(buffers));
  }
  return drawing;
}

} // namespace voluta::scene
