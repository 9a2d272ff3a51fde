// Helpers for VTK actors, and the common look of all solids.
#pragma once

#include "scene/range_mapper.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

class vtkPlane;

namespace voluta::scene {

// An actor whose mapper draws stretches of its data.
struct RangeActor {
  vtkSmartPointer<vtkActor> actor;
  vtkSmartPointer<RangeMapper> mapper;

  static RangeActor make(vtkRenderer* renderer);
  // A faint actor, visible through objects in front of it.
  static RangeActor halo(vtkRenderer* renderer);
  // Null shows nothing.
  void setData(vtkPolyData* data);
};

// Solid: lit, with a faint shine. Lines: one pixel wide, unlit.
vtkSmartPointer<vtkActor> addSolid(vtkRenderer* renderer);
vtkSmartPointer<vtkActor> addLines(vtkRenderer* renderer);
void setData(vtkActor* actor, vtkPolyData* data);
void setColour(vtkActor* actor, const Colour& colour);
// Gives each point of the actor's data a colour, three bytes each.
void setColours(const RangeActor& shown, const std::vector<std::uint8_t>& rgb);
void setPose(vtkActor* actor, const Eigen::Affine3d& world_T_model);
void giveSolidLook(vtkActor* actor);
// Cuts the actors by a plane; null: shows them whole.
void cutBy(vtkPlane* plane, const std::vector<vtkActor*>& actors);
// Returns a flat ring about z, through which the marked place stays visible.
vtkSmartPointer<vtkPolyData> ring(double inner, double outer);

// Adds two lights that move with the camera: one from the upper left, and a weaker fill light.
void addLights(vtkRenderer* renderer);

} // namespace voluta::scene
