#include "base/error.h"
#include "robot/link_meshes.h"
#include "scene/drawing_data.h"
#include "scene/shape_mesh.h"
#include "scene/surface.h"

#include <algorithm>
#include <functional>

namespace voluta::scene {

namespace {

constexpr double kFeatureAngleDeg = 30.0; // of links

using Body = robot::Body;
using Surface = vtkSmartPointer<vtkPolyData>;

Surface solidsOf(const Body& body) {
  MeshBuffers buffers;
  for (const robot::Shape& shape : body.shapes)
    addShape(buffers, shape);
  return polyDataOf(buffers);
}

std::shared_ptr<const CellDrawing> drawn(const robot::Cell& cell,
                                         const std::function<Surface(std::size_t body)>& link) {
  auto drawing = std::make_shared<CellDrawing>(CellDrawing{cell, {}});
  for (std::size_t i = 0; i < cell.bodies().size(); ++i) {
    const Body& body = cell.bodies()[i];
    drawing->bodies.push_back(body.role == robot::BodyRole::Link ? link(i) : solidsOf(body));
  }
  return drawing;
}

} // namespace

std::shared_ptr<const CellDrawing> drawCell(const robot::Cell& cell,
                                            const std::vector<robot::LinkMesh>& links) {
  return drawn(cell, [&](std::size_t i) {
    const Body& body = cell.bodies()[i];
    const auto mesh = std::ranges::find(links, body.frame, &robot::LinkMesh::frame);
    return mesh == links.end() ? solidsOf(body)
                               : shadedSurface(plainSurface(mesh->mesh), kFeatureAngleDeg);
  });
}

std::shared_ptr<const CellDrawing> drawCell(const robot::Cell& cell, const CellDrawing& before) {
  base::require(cell.robot().id == before.cell.robot().id, "the arm that was drawn before");
  // Links come first among a cell's bodies.
  return drawn(cell, [&](std::size_t i) { return before.bodies[i]; });
}

} // namespace voluta::scene
