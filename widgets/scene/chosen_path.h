// The line along the chosen path of the beads.
#pragma once

#include "scene/actors.h"
#include "scene/drawing_data.h"
#include "scene/view_state.h"

#include <cstddef>
#include <optional>

namespace voluta::scene {

class ChosenPath {
public:
  explicit ChosenPath(vtkRenderer* renderer);

  void setColour(const Colour& colour);
  // `paths`: null if they are not shown.
  void show(const ViewState& view, const PathsDrawing* paths);
  vtkActor* actor() const { return line_; }

private:
  vtkSmartPointer<vtkActor> line_;
  // Those for which the line was built
  const PathsDrawing* paths_ = nullptr;
  std::optional<std::size_t> path_;
};

} // namespace voluta::scene
