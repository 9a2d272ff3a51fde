// View settings that apply on all pages: colours, section plane, marker.
#pragma once

#include "scene/sight.h"
#include "scene/view_state.h"

#include <Eigen/Geometry>
#include <QObject>
#include <optional>
#include <utility>

namespace voluta::window {

struct Look {
  scene::ColourBy colourBy = scene::ColourBy::Kind;
  bool beads = true, pieceNumbers = true;
  std::uint32_t hiddenKinds = 0; // As ViewState::hiddenKinds
  bool arm = false;              // whole on the Prepare page too, not dimmed
  bool section = false, sectionFlipped = false;
  int sectionAxis = 0;       // x, y, z
  double sectionPlace = 0.5; // share of the part's bounding box along the axis
  bool operator==(const Look&) const = default;
};

class Picture : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  const Look& look() const { return look_; }
  void setLook(const Look& look);
  // Place of a finding, work frame; none: no marker.
  void setMarker(const std::optional<Eigen::Vector3d>& place) {
    marker_ = place;
    sight_.reset();
  }
  // Sets the objects that hide the marker from the eye; valid until the next marker.
  // `normalInWork`: towards the eye.
  void setHidden(const scene::Between& hides, const Eigen::Vector3d& normalInWork) {
    sight_ = {hides, normalInWork};
  }
  // Cuts away the objects that hide the marker and omits those that cannot be cut.
  void reveal(scene::ViewState& view) const;
  // Returns the initial view of every page. `partBox`: of the part, work frame; may be empty.
  scene::ViewState base(const Eigen::AlignedBox3d& partBox) const;

signals:
  void lookChanged();

private:
  Look look_;
  std::optional<Eigen::Vector3d> marker_;
  std::optional<std::pair<scene::Between, Eigen::Vector3d>> sight_;
};

} // namespace voluta::window
