// Feature edges of a surface.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace voluta::scene {

// Returns lines along edges at which the surface turns by more than `angleDeg`, and, if
// `openEdges`, along its open and non-manifold edges.
vtkSmartPointer<vtkPolyData> featureEdges(vtkPolyData* surface, double angleDeg, bool openEdges);

} // namespace voluta::scene
