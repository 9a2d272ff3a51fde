#include "scene/drawing_data.h"
#include "scene/mesh_buffers.h"

#include <vtkFeatureEdges.h>
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

  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(raw);
  edges->SetFeatureAngle(kFeatureAngleDeg);
  edges->BoundaryEdgesOn();
  edges->FeatureEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  drawing->edges = edges->GetOutput();
  drawing->edges->ComputeBounds();
  return drawing;
}

} // namespace voluta::scene
