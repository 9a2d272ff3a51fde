// Small helpers over VTK's actors, and the look that all solids share.
#pragma once

#include "scene/range_mapper.h"

#include <Eigen/Geometry>
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace voluta::scene {

// An actor whose mapper draws stretches of its data.
struct RangeActor {
  vtkSmartPointer<vtkActor> actor;
  vtkSmartPointer<RangeMapper> mapper;

  static RangeActor make(vtkRenderer* renderer);
  // Faint, and seen through whatever is before it.
  static RangeActor halo(vtkRenderer* renderer);
  // Null: nothing.
  void setData(vtkPolyData* data);
};

// Solid: lit, with a faint shine. Lines: one pixel, not lit.
vtkSmartPointer<vtkActor> addSolid(vtkRenderer* renderer);
vtkSmartPointer<vtkActor> addLines(vtkRenderer* renderer);
void setData(vtkActor* actor, vtkPolyData* data);
void setColour(vtkActor* actor, const Colour& colour);
void setPose(vtkActor* actor, const Eigen::Affine3d& world_T_model);
void giveSolidLook(vtkActor* actor);

// Two lights that go with the camera: from above on the left, and a weaker one against the shade.
void addLights(vtkRenderer* renderer);

} // namespace voluta::scene
