#include "scene/cell_actors.h"

#include <vtkMapper.h>
#include <vtkProperty.h>

namespace voluta::scene {

namespace {
constexpr double kSolidsOpacity = 0.28;
constexpr double kFromBelow = 0.25;
constexpr double kDimmed = 0.13;
} // namespace

void CellActors::setDrawing(const CellDrawing* drawing) {
  for (const auto* actors : {&pieces_, &solids_})
    for (const auto& actor : *actors)
      renderer_->RemoveActor(actor);
  pieces_.clear();
  solids_.clear();
  if (purgePlace_)
    renderer_->RemoveActor(purgePlace_);
  purgePlace_ = nullptr;
  drawing_ = drawing;
  if (!drawing)
    return;
  for (const CellPiece& piece : drawing->pieces) {
    pieces_.push_back(addSolid(renderer_));
    setData(pieces_.back(), piece.surface);
    pieces_.back()->GetMapper()->SetScalarVisibility(piece.coloured);
  }
  for (const auto& solid : drawing->solids) {
    solids_.push_back(addSolid(renderer_));
    setData(solids_.back(), solid);
    solids_.back()->GetProperty()->SetOpacity(kSolidsOpacity);
    solids_.back()->GetProperty()->BackfaceCullingOn();
  }
  if (drawing->purgePlace) {
    purgePlace_ = addSolid(renderer_);
    setData(purgePlace_, drawing->purgePlace);
  }
  colour();
}

void CellActors::setTheme(const Theme& theme) {
  theme_ = theme;
  colour();
}

void CellActors::colour() {
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    setColour(pieces_[i], colourOf(drawing_->cell.bodies()[drawing_->pieces[i].body]));
  for (const auto& solid : solids_)
    setColour(solid, theme_.front);
  if (purgePlace_)
    setColour(purgePlace_, theme_.front);
}

const Colour& CellActors::colourOf(const robot::Body& body) const {
  switch (body.role) {
  case robot::BodyRole::Link:
    return body.frame % 2 == 0 ? theme_.robotLight : theme_.robotDark;
  case robot::BodyRole::Head:
    return theme_.head;
  case robot::BodyRole::Platform:
    return theme_.platform;
  case robot::BodyRole::Holder:
    return theme_.robotDark;
  case robot::BodyRole::Obstacle:
    break;
  }
  return theme_.obstacle;
}

void CellActors::pose(const std::vector<Eigen::Isometry3d>& world_T_frame) {
  const auto poseOf = [&](int frame) { return world_T_frame[static_cast<std::size_t>(frame)]; };
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    setPose(pieces_[i], poseOf(drawing_->pieces[i].frame));
  for (std::size_t i = 0; i < solids_.size(); ++i)
    setPose(solids_[i], poseOf(drawing_->cell.bodies()[i].frame));
  if (purgePlace_)
    setPose(purgePlace_, poseOf(drawing_->cell.worldFrame()));
}

bool CellActors::shows(const ViewState& view, std::size_t body, bool byPlatform) const {
  const robot::BodyRole role = drawing_->cell.bodies()[body].role;
  return view.cell && view.roles[static_cast<std::size_t>(role)] &&
         !(role == robot::BodyRole::Platform && byPlatform);
}

void CellActors::show(const ViewState& view, bool byPlatform) {
  dimmed_ = view.cellDimmed;
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    pieces_[i]->SetVisibility(shows(view, drawing_->pieces[i].body, byPlatform));
  // Obstacles are drawn as their collision solids.
  for (std::size_t i = 0; i < solids_.size(); ++i)
    solids_[i]->SetVisibility(view.collisionSolids && shows(view, i, byPlatform) &&
                              drawing_->cell.bodies()[i].role != robot::BodyRole::Obstacle);
  if (purgePlace_)
    purgePlace_->SetVisibility(view.cell && !view.cellDimmed);
}

void CellActors::setSeenThrough(bool on) {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const robot::BodyRole role = drawing_->cell.bodies()[drawing_->pieces[i].body].role;
    const bool beneath = role == robot::BodyRole::Platform || role == robot::BodyRole::Obstacle;
    const bool faint = dimmed_ && role != robot::BodyRole::Platform;
    pieces_[i]->GetProperty()->SetOpacity(faint ? kDimmed : on && beneath ? kFromBelow : 1.0);
    pieces_[i]->GetProperty()->SetBackfaceCulling(faint);
  }
}

Eigen::AlignedBox3d CellActors::box() const {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (pieces_[i]->GetVisibility() &&
        drawing_->cell.bodies()[drawing_->pieces[i].body].role != robot::BodyRole::Obstacle) {
      const double* b = pieces_[i]->GetBounds();
      box.extend(Eigen::Vector3d(b[0], b[2], b[4]));
      box.extend(Eigen::Vector3d(b[1], b[3], b[5]));
    }
  return box;
}

} // namespace voluta::scene
