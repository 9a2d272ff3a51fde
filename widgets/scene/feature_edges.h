// Edges of a surface worth a line.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace voluta::scene {

// Lines along edges at which the surface turns by more than `angleDeg`, and where asked along its
// open and non-manifold edges.
vtkSmartPointer<vtkPolyData> featureEdges(vtkPolyData* surface, double angleDeg, bool openEdges);

} // namespace voluta::scene
