#include "scene/insert_actors.h"

namespace voluta::scene {

void InsertActors::setDrawing(const PathsDrawing* paths) {
  for (vtkActor* actor : actors())
    renderer_->RemoveActor(actor);
  inserts_.clear();
  paths_ = paths;
  if (!paths)
    return;
  for (const InsertDrawing& insert : paths->inserts) {
    const One one{addSolid(renderer_), addLines(renderer_)};
    setData(one.body, insert.surface);
    setData(one.edges, insert.edges);
    inserts_.push_back(one);
  }
  setTheme(theme_);
}

void InsertActors::setTheme(const Theme& theme) {
  theme_ = theme;
  for (const One& one : inserts_) {
    setColour(one.body, theme.insert);
    setColour(one.edges, theme.partEdges);
  }
}

void InsertActors::show(const ViewState& view, bool on) {
  for (std::size_t i = 0; i < inserts_.size(); ++i) {
    const InsertDrawing& insert = paths_->inserts[i];
    const bool isIn =
        on && insert.layer - 1 <= view.lastLayer && insert.first <= view.printedWaypoints;
    inserts_[i].body->SetVisibility(isIn);
    inserts_[i].edges->SetVisibility(isIn);
  }
}

std::vector<vtkActor*> InsertActors::actors() const {
  std::vector<vtkActor*> actors;
  for (const One& one : inserts_)
    actors.insert(actors.end(), {one.body.Get(), one.edges.Get()});
  return actors;
}

} // namespace voluta::scene
