#include "scene/platform_actors.h"

#include <algorithm>
#include <vtkMapper.h>
#include <vtkProperty.h>

namespace voluta::scene {

namespace {
constexpr auto kPlatformRole = static_cast<std::size_t>(robot::BodyRole::Platform);
// length of rod to include on either side, relative to the printed length
constexpr double kRodBesideShare = 0.25;
constexpr double kPlateFromBelow = 0.25;
constexpr double kRulingOpacity = 0.45;
constexpr float kAxisPixels = 2.5F;
constexpr double kReachOpacity = 0.5;
} // namespace

PlatformActors::PlatformActors(vtkRenderer* renderer)
    : plate_(addSolid(renderer)), rod_(addSolid(renderer)), base_(addSolid(renderer)),
      grid_(addLines(renderer)), outline_(addLines(renderer)), ruling_(addLines(renderer)),
      axisX_(addLines(renderer)), axisY_(addLines(renderer)), reach_(addSolid(renderer)) {
  for (vtkActor* axis : {axisX_.Get(), axisY_.Get()})
    axis->GetProperty()->SetLineWidth(kAxisPixels);
  ruling_->GetProperty()->SetOpacity(kRulingOpacity);
  reach_->GetProperty()->SetOpacity(kReachOpacity);
  reach_->GetProperty()->LightingOff();
  reach_->GetMapper()->ScalarVisibilityOn();
}

void PlatformActors::setDrawing(const PlatformDrawing* drawing) {
  setData(plate_, drawing ? drawing->plate.Get() : nullptr);
  setData(rod_, drawing && drawing->rod ? drawing->rod->surface.Get() : nullptr);
  setData(base_, drawing && drawing->body ? drawing->body->surface.Get() : nullptr);
  setData(outline_, drawing ? drawing->outline.Get() : nullptr);
  setData(ruling_, drawing ? drawing->ruling.Get() : nullptr);
  setData(axisX_, drawing ? drawing->axisX.Get() : nullptr);
  setData(axisY_, drawing ? drawing->axisY.Get() : nullptr);
  setData(grid_, drawing ? drawing->grid.Get() : nullptr);
  drawing_ = drawing;
}

void PlatformActors::setReach(const ReachDrawing* reach) {
  setData(reach_, reach ? reach->surface.Get() : nullptr);
  reachDrawing_ = reach;
}

void PlatformActors::setTheme(const Theme& theme) {
  for (vtkActor* actor : {plate_.Get(), rod_.Get(), base_.Get()})
    setColour(actor, theme.platform);
  setColour(outline_, theme.platformEdges);
  setColour(grid_, theme.grid);
  setColour(ruling_, theme.platformEdges);
  setColour(axisX_, theme.axisX);
  setColour(axisY_, theme.axisY);
}

void PlatformActors::pose(const Eigen::Isometry3d& world_T_work) {
  for (vtkActor* actor : {plate_.Get(), rod_.Get(), outline_.Get(), grid_.Get(), reach_.Get(),
                          ruling_.Get(), axisX_.Get(), axisY_.Get()})
    setPose(actor, world_T_work);
  setPose(base_, world_T_work * Eigen::Translation3d(0.0, 0.0, kPlateTopMm));
}

void PlatformActors::show(const ViewState& view, bool byCell) {
  const bool on = view.platform && drawing_;
  plate_->SetVisibility(on && !byCell);
  rod_->SetVisibility(on && drawing_->rod && (!byCell || view.roles[kPlatformRole]));
  base_->SetVisibility(on);
  outline_->SetVisibility(on && (!drawing_->rod || showsRod()));
  grid_->SetVisibility(on && !byCell);
  for (vtkActor* ruled : {ruling_.Get(), axisX_.Get(), axisY_.Get()})
    ruled->SetVisibility(on && view.plateRuled);
  reach_->SetVisibility(view.reach && reachDrawing_);
}

void PlatformActors::lookFrom(const Eigen::Vector3d& eye) {
  plate_->GetProperty()->SetOpacity(eye.z() < 0.0 ? kPlateFromBelow : 1.0);
}

Eigen::AlignedBox3d PlatformActors::rodBeside(const Eigen::AlignedBox3d& shown) const {
  Eigen::AlignedBox3d box = drawing_->rod->box;
  if (shown.isEmpty())
    return box;
  const double beside = kRodBesideShare * shown.sizes().maxCoeff();
  box.min().x() = std::max(box.min().x(), shown.min().x() - beside);
  box.max().x() = std::min(box.max().x(), shown.max().x() + beside);
  return box;
}

} // namespace voluta::scene
