#include "scene/feature_edges.h"

#include <vtkFeatureEdges.h>
#include <vtkNew.h>

namespace voluta::scene {

vtkSmartPointer<vtkPolyData> featureEdges(vtkPolyData* surface, double angleDeg, bool openEdges) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->SetFeatureAngle(angleDeg);
  edges->SetBoundaryEdges(openEdges);
  edges->FeatureEdgesOn();
  edges->SetNonManifoldEdges(openEdges);
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  edges->GetOutput()->ComputeBounds();
  return edges->GetOutput();
}

} // namespace voluta::scene
