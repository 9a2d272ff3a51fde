// The parts of a job beside the active one.
#pragma once

#include "scene/actors.h"
#include "scene/drawing_data.h"
#include "scene/theme.h"

#include <Eigen/Geometry>
#include <memory>
#include <vector>

namespace voluta::scene {

class OtherParts {
public:
  explicit OtherParts(vtkRenderer* renderer) : renderer_(renderer) {}

  // Null: no such part, as at the place of the active one.
  void setDrawings(const std::vector<std::shared_ptr<const PartDrawing>>& drawings);
  void setTheme(const Theme& theme);
  void show(bool on, double opacity);
  void pose(const Eigen::Isometry3d& world_T_work);

  // Returns the actors that a section plane cuts.
  std::vector<vtkActor*> actors() const;

private:
  struct One {
    vtkSmartPointer<vtkActor> surface, edges;
  };

  vtkRenderer* renderer_;
  Theme theme_;
  std::vector<One> parts_;
};

} // namespace voluta::scene
