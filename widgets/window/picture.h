// How the picture is looked at, whatever page is on show: colours, section plane, marker.
#pragma once

#include "scene/view_state.h"

#include <Eigen/Geometry>
#include <QObject>
#include <optional>

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
  void setMarker(const std::optional<Eigen::Vector3d>& place) { marker_ = place; }
  // What every page begins with. `partBox`: of the part, work frame; may be empty.
  scene::ViewState base(const Eigen::AlignedBox3d& partBox) const;

signals:
  void lookChanged();

private:
  Look look_;
  std::optional<Eigen::Vector3d> marker_;
};

} // namespace voluta::window
