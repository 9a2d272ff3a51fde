#include "scene/chosen_path.h"

#include <vtkProperty.h>

namespace voluta::scene {

namespace {
constexpr float kPixels = 3.0F;
} // namespace

ChosenPath::ChosenPath(vtkRenderer* renderer) : line_(addLines(renderer)) {
  line_->GetProperty()->SetLineWidth(kPixels);
}

void ChosenPath::setColour(const Colour& colour) {
  scene::setColour(line_, colour);
}

void ChosenPath::show(const ViewState& view, const PathsDrawing* paths) {
  const bool on = paths && view.path;
  line_->SetVisibility(on);
  if (!on || (paths_ == paths && path_ == view.path))
    return;
  paths_ = paths;
  path_ = view.path;
  setData(line_, pathLine(*paths, *view.path));
}

} // namespace voluta::scene
