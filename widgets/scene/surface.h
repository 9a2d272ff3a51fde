// Conversion of meshes to surfaces for display.
#pragma once

#include "geometry/triangle_mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace voluta::scene {

// Returns the unmodified vertices and triangles.
vtkSmartPointer<vtkPolyData> plainSurface(const geometry::TriangleMesh& mesh);
// Returns the surface with normals, smooth up to a feature angle (sharper edges are split); its
// bounds are computed.
vtkSmartPointer<vtkPolyData> shadedSurface(vtkPolyData* plain, double featureAngleDeg);

} // namespace voluta::scene
