#include "scene/cell_actors.h"

namespace voluta::scene {

void CellActors::setDrawing(const CellDrawing* drawing) {
  for (const auto& body : bodies_)
    renderer_->RemoveActor(body);
  bodies_.clear();
  drawing_ = drawing;
  if (drawing)
    for (const auto& data : drawing->bodies) {
      bodies_.push_back(addSolid(renderer_));
      setData(bodies_.back(), data);
    }
  colour();
}

void CellActors::setTheme(const Theme& theme) {
  theme_ = theme;
  colour();
}

void CellActors::colour() {
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    setColour(bodies_[i], colourOf(drawing_->cell.bodies()[i]));
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
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    setPose(bodies_[i], world_T_frame[static_cast<std::size_t>(drawing_->cell.bodies()[i].frame)]);
}

void CellActors::show(const ViewState& view, bool byPlatform) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const robot::BodyRole role = drawing_->cell.bodies()[i].role;
    bodies_[i]->SetVisibility(view.cell && view.roles[static_cast<std::size_t>(role)] &&
                              !(role == robot::BodyRole::Platform && byPlatform));
  }
}

Eigen::AlignedBox3d CellActors::box() const {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (drawing_->cell.bodies()[i].role != robot::BodyRole::Obstacle) {
      const double* b = bodies_[i]->GetBounds();
      box.extend(Eigen::Vector3d(b[0], b[2], b[4]));
      box.extend(Eigen::Vector3d(b[1], b[3], b[5]));
    }
  return box;
}

} // namespace voluta::scene
