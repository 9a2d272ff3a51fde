// The viewport with its overlays and the bars beside and below it.
#pragma once

#include "scene/theme.h"
#include "window/window_theme.h"

#include <QWidget>

namespace voluta::timeline {
class LayerRangeSlider;
class TimelineBar;
} // namespace voluta::timeline
namespace voluta::viewer {
class Viewport;
}

namespace voluta::window {

class LegendView;
class PictureBadge;
class ViewTools;
class Welcome;

scene::Theme sceneTheme(Appearance appearance);
scene::Theme sceneTheme(const QPalette& palette); // of the appearance with that palette

class PictureArea : public QWidget {
  Q_OBJECT

public:
  explicit PictureArea(Appearance appearance, QWidget* parent = nullptr);

  viewer::Viewport& viewport() { return *viewport_; }
  LegendView& legend() { return *legend_; }
  PictureBadge& badge() { return *badge_; }
  Welcome& welcome() { return *welcome_; }
  ViewTools& tools() { return *tools_; }
  timeline::LayerRangeSlider& layers() { return *layers_; }
  timeline::TimelineBar& timeline() { return *timeline_; }

  // Ambient occlusion, also the next time.
  void darkenCorners(bool on);

private:
  viewer::Viewport* viewport_;
  LegendView* legend_;
  PictureBadge* badge_;
  Welcome* welcome_;
  ViewTools* tools_;
  timeline::LayerRangeSlider* layers_;
  timeline::TimelineBar* timeline_;
};

} // namespace voluta::window
