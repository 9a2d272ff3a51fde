#include "scene/drawing_data.h"
#include "scene/feature_edges.h"
#include "scene/mesh_buffers.h"

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>

namespace voluta::scene {

namespace {
constexpr double kFeatureAngleDeg = 45.0;
}

std::shared_ptr<const PartDrawing> drawPart(const geometry::TriangleMesh& part) {
  auto drawing = std::make_shared<PartDrawing>();
  drawing->mesh = part;
  MeshBuffers buffers;
  for (const Eigen::Vector3d& v : part.vertices) {
    buffers.addPoint(v);
    drawing->box.extend(v);
  }
  for (const auto& t : part.triangles)
    buffers.addTriangle(t[0], t[1], t[2]);
  const auto raw = polyDataOf(buffers);

  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(raw);
  normals->SetFeatureAngle(kFeatureAngleDeg);
  normals->SplittingOn();
  normals->ConsistencyOff();
  normals->Update();
  drawing->surface = normals->GetOutput();
  drawing->surface->ComputeBounds();

  drawing->edges = featureEdges(raw, kFeatureAngleDeg, true);
  return drawing;
}

} // namespace voluta::scene
