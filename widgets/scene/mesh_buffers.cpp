#include "scene/mesh_buffers.h"

#include <cstring>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

namespace voluta::scene {

namespace {

template <typename Array, typename T>
vtkSmartPointer<Array> arrayOf(const std::vector<T>& values, int components) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  if (!values.empty())
    std::memcpy(array->GetPointer(0), values.data(), values.size() * sizeof(T));
  return array;
}

vtkSmartPointer<vtkCellArray> cellsOf(const std::vector<std::int32_t>& ids, int corners) {
  std::vector<std::int32_t> offsets(ids.size() / static_cast<std::size_t>(corners) + 1);
  for (std::size_t i = 0; i < offsets.size(); ++i)
    offsets[i] = static_cast<std::int32_t>(i) * corners;
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(arrayOf<vtkTypeInt32Array>(offsets, 1), arrayOf<vtkTypeInt32Array>(ids, 1));
  return cells;
}

} // namespace

vtkSmartPointer<vtkPolyData> polyDataOf(const MeshBuffers& buffers) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(arrayOf<vtkFloatArray>(buffers.points, 3));
  data->SetPoints(points);
  if (!buffers.corners.empty())
    data->SetPolys(cellsOf(buffers.corners, 3));
  if (!buffers.lineEnds.empty())
    data->SetLines(cellsOf(buffers.lineEnds, 2));
  if (!buffers.normals.empty()) {
    auto normals = arrayOf<vtkFloatArray>(buffers.normals, 3);
    normals->SetName("Normals");
    data->GetPointData()->SetNormals(normals);
  }
  if (!buffers.rgb.empty())
    data->GetPointData()->SetScalars(arrayOf<vtkUnsignedCharArray>(buffers.rgb, 3));
  data->ComputeBounds();
  return data;
}

void addPointArray(vtkPolyData* data, const char* name, int components,
                   const std::vector<float>& values) {
  auto array = arrayOf<vtkFloatArray>(values, components);
  array->SetName(name);
  data->GetPointData()->AddArray(array);
}

} // namespace voluta::scene
