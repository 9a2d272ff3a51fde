#include "window/picture_area.h"

#include "forms/colours.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "viewer/viewport.h"
#include "window/legend_view.h"
#include "window/picture_badge.h"
#include "window/view_tools.h"
#include "window/welcome.h"

#include <QSettings>
#include <QVBoxLayout>

namespace voluta::window {

namespace {
constexpr const char* kDarkCorners = "view/darkCorners";
}

scene::Theme sceneTheme(Appearance appearance) {
  switch (appearance) {
  case Appearance::Dark:
    return scene::darkTheme();
  case Appearance::HighContrast:
    return scene::highContrastTheme();
  case Appearance::Light:
    break;
  }
  return scene::lightTheme();
}

scene::Theme sceneTheme(const QPalette& palette) {
  return sceneTheme(forms::isHighContrast(palette) ? Appearance::HighContrast
                    : forms::isDark(palette)       ? Appearance::Dark
                                                   : Appearance::Light);
}

PictureArea::PictureArea(Appearance appearance, QWidget* parent)
    : QWidget(parent), viewport_(new viewer::Viewport(sceneTheme(appearance), this)),
      legend_(new LegendView(viewport_)), badge_(new PictureBadge(viewport_)),
      welcome_(new Welcome(viewport_)), tools_(new ViewTools(viewport_)),
      layers_(new timeline::LayerRangeSlider(this)), timeline_(new timeline::TimelineBar(this)) {
  viewport_->setLegendWidget(legend_);
  connect(tools_, &ViewTools::fitted, viewport_, [this] { viewport_->setToolsWidget(tools_); });
  layers_->setObjectName("layerSlider");
  timeline_->setObjectName("timeline");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  row->addWidget(viewport_, 1);
  row->addWidget(layers_);
  column->addLayout(row, 1);
  column->addWidget(timeline_);
  // While dragging, draw faster with less detail.
  using viewer::Viewport;
  connect(layers_, &timeline::LayerRangeSlider::dragging, viewport_, &Viewport::setDragging);
  connect(timeline_, &timeline::TimelineBar::dragging, viewport_, &Viewport::setDragging);
  connect(timeline_, &timeline::TimelineBar::playingChanged, viewport_, &Viewport::setDragging);
  connect(viewport_, &viewer::VtkView::openGlReady, this, [this] {
    viewport_->setAmbientOcclusion(
        QSettings().value(kDarkCorners, !viewport_->isDrawnByProcessor()).toBool());
  });
  connect(viewport_, &viewer::VtkView::openGlMissing, this, [this](const QString& found) {
    welcome_->setMessage(tr("The viewport needs OpenGL 3.2; this display offers %1. Update the "
                            "graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1. Planning and export "
                            "work without a picture.")
                             .arg(found));
    welcome_->show();
  });
}

void PictureArea::darkenCorners(bool on) {
  viewport_->setAmbientOcclusion(on);
  QSettings().setValue(kDarkCorners, on);
}

} // namespace voluta::window
