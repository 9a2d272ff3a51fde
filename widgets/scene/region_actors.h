// Actors of a part's regions: translucent bodies and their edges.
#pragma once

#include "scene/actors.h"
#include "scene/drawing_data.h"
#include "scene/theme.h"
#include "scene/view_state.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::scene {

class RegionActors {
public:
  explicit RegionActors(vtkRenderer* renderer);

  // Null: none. The drawing must outlive its display.
  void setDrawing(const RegionsDrawing* drawing);
  void setTheme(const Theme& theme);
  void show(const ViewState& view, const Eigen::Isometry3d& world_T_work);
  void hide();

  // Returns the actors that a section plane cuts.
  std::vector<vtkActor*> actors() const;

private:
  struct One {
    vtkSmartPointer<vtkActor> body, edges;
  };

  vtkRenderer* renderer_;
  Theme theme_;
  const RegionsDrawing* drawing_ = nullptr;
  std::vector<One> regions_;
};

} // namespace voluta::scene
