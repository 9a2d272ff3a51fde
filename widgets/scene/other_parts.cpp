#include "scene/other_parts.h"

#include <vtkProperty.h>

namespace voluta::scene {

void OtherParts::setDrawings(const std::vector<std::shared_ptr<const PartDrawing>>& drawings) {
  for (vtkActor* actor : actors())
    renderer_->RemoveActor(actor);
  parts_.clear();
  for (const auto& drawing : drawings) {
    if (!drawing)
      continue;
    const One& one = parts_.emplace_back(One{addSolid(renderer_), addLines(renderer_)});
    setData(one.surface, drawing->surface);
    setData(one.edges, drawing->edges);
  }
  setTheme(theme_);
}

void OtherParts::setTheme(const Theme& theme) {
  theme_ = theme;
  for (const One& one : parts_) {
    setColour(one.surface, theme.otherPart);
    setColour(one.edges, theme.otherPartEdges);
  }
}

void OtherParts::show(bool on, double opacity) {
  for (const One& one : parts_) {
    one.surface->SetVisibility(on && opacity > 0.0);
    one.surface->GetProperty()->SetOpacity(opacity);
    one.surface->GetProperty()->SetBackfaceCulling(opacity < 1.0);
    one.edges->SetVisibility(on && opacity >= 1.0);
  }
}

void OtherParts::pose(const Eigen::Isometry3d& world_T_work) {
  for (vtkActor* actor : actors())
    setPose(actor, world_T_work);
}

std::vector<vtkActor*> OtherParts::actors() const {
  std::vector<vtkActor*> all;
  for (const One& one : parts_) {
    all.push_back(one.surface);
    all.push_back(one.edges);
  }
  return all;
}

} // namespace voluta::scene
