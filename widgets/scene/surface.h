// A mesh as a surface to be seen.
#pragma once

#include "geometry/triangle_mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace voluta::scene {

// Vertices and triangles as they are.
vtkSmartPointer<vtkPolyData> plainSurface(const geometry::TriangleMesh& mesh);
// With normals, smooth up to a feature angle (sharper edges are split); its bounds are computed.
vtkSmartPointer<vtkPolyData> shadedSurface(vtkPolyData* plain, double featureAngleDeg);

} // namespace voluta::scene
