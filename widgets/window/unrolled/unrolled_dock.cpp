#include "window/unrolled/unrolled_dock.h"

#include "document/document.h"
#include "plan/waypoints.h"
#include "scene/view_state.h"
#include "timeline/layer_range_slider.h"
#include "window/presenters/presenter.h"
#include "window/unrolled/unrolled_view.h"

#include <QCloseEvent>
#include <QSettings>
#include <algorithm>
#include <utility>

namespace voluta::window {

using project::Stage;

namespace {
constexpr const char* kWanted = "view/unrolled";
}

std::shared_ptr<const plan::ToolPlan> planOfLayers(const document::Document& document) {
  const auto layers = document.result(Stage::Layers), paths = document.result(Stage::Toolpath);
  return layers && paths && layersOf(layers->job) == layersOf(paths->job) ? paths->job.toolPlan
                                                                          : nullptr;
}

UnrolledDock::UnrolledDock(const document::Document& document, const Presenter& presenter,
                           const timeline::LayerRangeSlider& layers, QWidget* parent)
    : QDockWidget(parent), document_(document), presenter_(presenter), layers_(layers),
      view_(new UnrolledView(this)), wanted_(QSettings().value(kWanted, true).toBool()) {
  setObjectName("unrolledDock");
  setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
  view_->setObjectName("unrolled");
  setWidget(view_);
  hide();
  connect(view_, &UnrolledView::chosen, this, &UnrolledDock::chosen);
  connect(&document, &document::Document::resultChanged, this, [this](Stage stage) {
    if (stage == Stage::Layers || stage == Stage::Toolpath)
      chosen_.reset();
  });
}

void UnrolledDock::setWanted(bool wanted) {
  wanted_ = wanted;
  QSettings().setValue(kWanted, wanted);
}

bool UnrolledDock::offered() const {
  const auto result = document_.result(Stage::Layers);
  return result && result->job.items.size() == 1 && result->job.item().layers &&
         hasChart(*result->job.item().layers) &&
         !(document_.voxelsAhead() && presenter_.hasVoxels());
}

void UnrolledDock::showProgress(const std::optional<PrintProgress>& printProgress) {
  const bool on = printProgress && wanted_ && offered();
  if (on != isVisibleTo(parentWidget())) {
    setVisible(on);
    if (on && !std::exchange(sized_, true))
      emit firstShown();
  }
  if (!on)
    return;
  const auto stack = document_.result(Stage::Layers)->job.item().layers;
  view_->setPlan(stack, planOfLayers(document_));
  const int layer = std::max(0, std::min(printProgress->layer, stack->layerCount - 1));
  const QString number = tr("Layer %1 of %2").arg(layer + 1).arg(stack->layerCount);
  const QString top = layers_.topText(layer);
  view_->showLayer(layer, printProgress->end,
                   top.isEmpty() ? number : QString("%1, %2").arg(number, top));
  view_->choose(chosen_);
}

void UnrolledDock::choose(std::optional<std::size_t> waypoint) {
  chosen_ = waypoint;
}

void UnrolledDock::mark(scene::ViewState& view) const {
  const auto plan = planOfLayers(document_);
  const plan::ToolPath* path = plan && chosen_ ? plan::pathOf(*plan, *chosen_) : nullptr;
  if (!path || !view.paths)
    return;
  view.path = static_cast<std::size_t>(path - plan->paths.data());
  view.marker = plan->position[*chosen_];
}

void UnrolledDock::retranslate() {
  setWindowTitle(tr("Unrolled layer"));
}

void UnrolledDock::closeEvent(QCloseEvent* event) {
  setWanted(false);
  emit wantedChanged();
  QDockWidget::closeEvent(event);
}

} // namespace voluta::window
