#include "window/picture.h"

namespace voluta::window {

void Picture::setLook(const Look& look) {
  if (look == look_)
    return;
  look_ = look;
  emit lookChanged();
}

scene::ViewState Picture::base(const Eigen::AlignedBox3d& partBox) const {
  scene::ViewState view;
  view.marker = marker_;
  view.pieceNumbers = look_.pieceNumbers;
  view.colourBy = look_.colourBy;
  view.beads = look_.beads;
  view.hiddenKinds = look_.colourBy == scene::ColourBy::Kind ? look_.hiddenKinds : 0;
  view.sectionOn = look_.section && !partBox.isEmpty();
  if (view.sectionOn) {
    view.sectionNormal =
        (look_.sectionFlipped ? -1.0 : 1.0) * Eigen::Vector3d::Unit(look_.sectionAxis);
    view.sectionOrigin = partBox.min() + look_.sectionPlace * partBox.sizes();
  }
  return view;
}

void Picture::reveal(scene::ViewState& view) const {
  if (!marker_ || !sight_)
    return;
  const auto& [hides, normal] = *sight_;
  if (hides.printed) {
    view.sectionOn = true;
    view.sectionOrigin = *marker_;
    view.sectionNormal = normal;
  }
  view.platform = view.platform && !hides.platform;
  for (std::size_t role = 0; role < view.roles.size(); ++role)
    view.roles[role] = view.roles[role] && !hides.roles[role];
}

} // namespace voluta::window
