#include "scene/region_actors.h"

#include <vtkProperty.h>

namespace voluta::scene {

namespace {
constexpr double kOpacity = 0.32, kChosenOpacity = 0.62;
constexpr double kEdgeOpacity = 0.55, kOutlineOpacity = 0.35;
constexpr float kChosenEdgePixels = 2.0F;
} // namespace

Colour colourOf(RegionLook look, const Theme& theme) {
  switch (look) {
  case RegionLook::Layers:
    return theme.regionLayers;
  case RegionLook::Cut:
    return theme.regionCut;
  case RegionLook::Load:
    return theme.regionLoad;
  case RegionLook::Settings:
    break;
  }
  return theme.regionSettings;
}

RegionActors::RegionActors(vtkRenderer* renderer) : renderer_(renderer), theme_(lightTheme()) {}

void RegionActors::setDrawing(const RegionsDrawing* drawing) {
  for (vtkActor* actor : actors())
    renderer_->RemoveActor(actor);
  regions_.clear();
  drawing_ = drawing;
  if (!drawing)
    return;
  for (const RegionsDrawing::One& region : drawing->regions) {
    const One one{addSolid(renderer_), addLines(renderer_)};
    setData(one.body, region.surface);
    setData(one.edges, region.edges);
    // Only the walls that face the eye are drawn, so that a body has the same colour everywhere.
    one.body->GetProperty()->SetBackfaceCulling(true);
    regions_.push_back(one);
  }
  hide();
}

void RegionActors::setTheme(const Theme& theme) {
  theme_ = theme;
}

void RegionActors::hide() {
  for (vtkActor* actor : actors())
    actor->SetVisibility(false);
}

void RegionActors::show(const ViewState& view, const Eigen::Isometry3d& world_T_work) {
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    const One& one = regions_[i];
    const bool chosen = view.region == i && !view.regionOutlines;
    const Colour colour = colourOf(drawing_->regions[i].look, theme_);
    Eigen::Isometry3d pose = world_T_work;
    if (chosen)
      pose = pose * Eigen::Translation3d(view.regionMovedMm);
    for (vtkActor* actor : {one.body.Get(), one.edges.Get()}) {
      setColour(actor, colour);
      setPose(actor, pose);
    }
    one.body->SetVisibility(!view.regionOutlines);
    one.body->GetProperty()->SetOpacity(chosen ? kChosenOpacity : kOpacity);
    one.edges->SetVisibility(true);
    one.edges->GetProperty()->SetLineWidth(chosen ? kChosenEdgePixels : 1.0F);
    one.edges->GetProperty()->SetOpacity(chosen                ? 1.0
                                         : view.regionOutlines ? kOutlineOpacity
                                                               : kEdgeOpacity);
  }
}

std::vector<vtkActor*> RegionActors::actors() const {
  std::vector<vtkActor*> actors;
  for (const One& one : regions_)
    actors.insert(actors.end(), {one.body.Get(), one.edges.Get()});
  return actors;
}

} // namespace voluta::scene
