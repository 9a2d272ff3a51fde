// How the picture is looked at, whatever page is on show: colours, section plane, marker.
#pragma once

#include "scene/sight.h"
#include "scene/view_state.h"

#include <Eigen/Geometry>
#include <QObject>
#include <optional>
#include <utility>

namespace voluta::window {

struct Look {
  scene::ColourBy colourBy = scene::ColourBy::Layer;
  bool beads = true, pieceNumbers = true;
  bool section = false, sectionFlipped = false;
  int sectionAxis = 0;       // x, y, z
  double sectionPlace = 0.5; // share of the part's box along the axis
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
  // What hides the marker from the eye, until there is another one. `normalInWork`: towards the
  // eye.
  void setHidden(const scene::Between& hides, const Eigen::Vector3d& normalInWork) {
    sight_ = {hides, normalInWork};
  }
  // Cuts away what hides the marker, and leaves out what cannot be cut.
  void reveal(scene::ViewState& view) const;
  // What every page begins with. `partBox`: of the part, work frame; may be empty.
  scene::ViewState base(const Eigen::AlignedBox3d& partBox) const;

signals:
  void lookChanged();

private:
  Look look_;
  std::optional<Eigen::Vector3d> marker_;
  std::optional<std::pair<scene::Between, Eigen::Vector3d>> sight_;
};

} // namespace voluta::window
