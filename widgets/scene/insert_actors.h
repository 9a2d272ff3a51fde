// Actors of the bodies that are put into a part while it is printed.
#pragma once

#include "scene/actors.h"
#include "scene/drawing_data.h"
#include "scene/theme.h"
#include "scene/view_state.h"

#include <vector>

namespace voluta::scene {

class InsertActors {
public:
  explicit InsertActors(vtkRenderer* renderer) : renderer_(renderer) {}

  // Null: none. The drawing must outlive its display.
  void setDrawing(const PathsDrawing* paths);
  void setTheme(const Theme& theme);
  // Shows those whose room is complete with the last layer or waypoint shown. `on`: the paths are
  // shown.
  void show(const ViewState& view, bool on);

  // Returns the actors that a section plane cuts.
  std::vector<vtkActor*> actors() const;

private:
  struct One {
    vtkSmartPointer<vtkActor> body, edges;
  };

  vtkRenderer* renderer_;
  Theme theme_;
  const PathsDrawing* paths_ = nullptr;
  std::vector<One> inserts_;
};

} // namespace voluta::scene
