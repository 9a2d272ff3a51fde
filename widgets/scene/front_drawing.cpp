#include "geometry/triangle_mesh.h"
#include "scene/drawing_data.h"
#include "scene/feature_edges.h"
#include "scene/mesh_buffers.h"

namespace voluta::scene {

namespace {
constexpr double kFeatureAngleDeg = 12.0; // flat faces consist of several triangles
}

std::shared_ptr<const FrontDrawing> drawFront(const geometry::TriangleMesh& front) {
  auto drawing = std::make_shared<FrontDrawing>();
  MeshBuffers buffers;
  for (const Eigen::Vector3d& v : front.vertices)
    buffers.addPoint(v);
  for (const auto& t : front.triangles)
    buffers.addTriangle(t[0], t[1], t[2]);
  drawing->surface = polyDataOf(buffers);
  drawing->edges = featureEdges(drawing->surface, kFeatureAngleDeg, false);
  return drawing;
}

} // namespace voluta::scene
