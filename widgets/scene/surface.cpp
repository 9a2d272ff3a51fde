#include "scene/surface.h"

#include "scene/mesh_buffers.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyDataNormals.h>

namespace voluta::scene {

vtkSmartPointer<vtkPolyData> plainSurface(const geometry::TriangleMesh& mesh) {
  MeshBuffers buffers;
  for (const Eigen::Vector3d& v : mesh.vertices)
    buffers.addPoint(v);
  for (const auto& t : mesh.triangles)
    buffers.addTriangle(t[0], t[1], t[2]);
  return polyDataOf(buffers);
}

vtkSmartPointer<vtkPolyData> shadedSurface(vtkPolyData* plain, double featureAngleDeg) {
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(plain);
  normals->SetFeatureAngle(featureAngleDeg);
  normals->SplittingOn();
  normals->ConsistencyOff();
  normals->Update();
  vtkSmartPointer<vtkPolyData> surface = normals->GetOutput();
  surface->GetPolys()->ConvertTo32BitStorage(); // as for all meshes of this module
  surface->ComputeBounds();
  return surface;
}

} // namespace voluta::scene
