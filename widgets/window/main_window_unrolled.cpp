// The unrolled layer beside the viewport, and the path that is chosen in both.
#include "window/main_window.h"

#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/unrolled_view.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QSettings>
#include <algorithm>
#include <limits>
#include <utility>

namespace voluta::window {

using project::Stage;

namespace {
constexpr const char* kWanted = "view/unrolled";
constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
constexpr int kTreeShare = 150, kFindingsShare = 130, kUnrolledShare = 460; // of the column

const plan::ToolPath* pathOf(const plan::ToolPlan& plan, std::size_t waypoint) {
  const auto after =
      std::upper_bound(plan.paths.begin(), plan.paths.end(), waypoint,
                       [](std::size_t w, const plan::ToolPath& p) { return w < p.first; });
  return after == plan.paths.begin() || waypoint >= plan.waypointCount() ? nullptr : &*(after - 1);
}
} // namespace

void MainWindow::buildUnrolled() {
  unrolled_ = new UnrolledView(this);
  unrolled_->setObjectName("unrolled");
  unrolledDock_ = new QDockWidget(this);
  unrolledDock_->setObjectName("unrolledDock");
  unrolledDock_->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
  unrolledDock_->setWidget(unrolled_);
  addDockWidget(Qt::LeftDockWidgetArea, unrolledDock_);
  unrolledDock_->hide();
  unrolledDock_->installEventFilter(this);
  connect(unrolled_, &UnrolledView::chosen, this, &MainWindow::chooseWaypoint);
  connect(&document_, &document::Document::resultChanged, this, [this](Stage stage) {
    if (stage == Stage::Layers || stage == Stage::Toolpath) {
      chosenWaypoint_.reset();
      showUnrolled();
    }
  });
}

void MainWindow::addUnrolledAction(QAction* action) {
  unrolledAction_ = action;
  action->setCheckable(true);
  action->setChecked(QSettings().value(kWanted, true).toBool());
  connect(action, &QAction::toggled, this, [this](bool on) {
    QSettings().setValue(kWanted, on);
    showUnrolled();
  });
}

// Closed by its own button it stays closed until it is asked for again.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == unrolledDock_ && event->type() == QEvent::Close && !closing_)
    unrolledAction_->setChecked(false);
  return QMainWindow::eventFilter(watched, event);
}

// Which paths the layers on show have: none that were made from other layers.
std::shared_ptr<const plan::ToolPlan> MainWindow::planOfLayers() const {
  const auto layers = document_.result(Stage::Layers), paths = document_.result(Stage::Toolpath);
  return layers && paths && layers->job.layers == paths->job.layers ? paths->job.toolPlan : nullptr;
}

void MainWindow::showUnrolled() {
  if (!unrolled_)
    return;
  const auto result = document_.result(Stage::Layers);
  const auto stack = result ? result->job.layers : nullptr;
  const auto plan = planOfLayers();
  const bool offered =
      stack && hasChart(*stack) && !(document_.voxelsAhead() && presenter_->hasVoxels());
  unrolledAction_->setEnabled(offered);
  const bool on = offered && unrolledAction_->isChecked() &&
                  (page() == Page::Layers || page() == Page::Simulate);
  if (on != unrolledDock_->isVisibleTo(this)) {
    unrolledDock_->setVisible(on);
    // Its own share of the column once; then it is the user's.
    if (on && !std::exchange(unrolledSized_, true))
      resizeDocks({partDock_, findingsDock_, unrolledDock_},
                  {kTreeShare, kFindingsShare, kUnrolledShare}, Qt::Vertical);
  }
  if (!on)
    return;
  unrolled_->setPlan(stack, plan);
  int layer = std::max(0, std::min(layers_->last(), stack->layerCount - 1));
  std::size_t laidEnd = kAll;
  if (page() == Page::Simulate) {
    laidEnd = viewport_->view().printedWaypoints;
    const std::size_t last = std::max<std::size_t>(laidEnd, 1) - 1;
    if (const plan::ToolPath* path = plan ? pathOf(*plan, last) : nullptr)
      layer = path->layer;
  } else if (const auto& moves = presenter_->waypointsOf(layer);
             plan && timeline_->mode() == timeline::BarMode::Moves &&
             timeline_->move() < static_cast<int>(moves.size())) {
    laidEnd = moves[static_cast<std::size_t>(timeline_->move())];
  }
  const QString number = tr("Layer %1 of %2").arg(layer + 1).arg(stack->layerCount);
  const QString top = layers_->topText(layer);
  unrolled_->showLayer(layer, laidEnd, top.isEmpty() ? number : QString("%1, %2").arg(number, top));
  unrolled_->choose(chosenWaypoint_);
}

// Both views show the path, and the nozzle goes to the waypoint.
void MainWindow::chooseWaypoint(std::optional<std::size_t> waypoint) {
  const auto plan = planOfLayers();
  const plan::ToolPath* path = plan && waypoint ? pathOf(*plan, *waypoint) : nullptr;
  chosenWaypoint_ = path ? waypoint : std::nullopt;
  if (path && page() == Page::Layers) {
    layers_->setRange(layers_->single() ? path->layer : std::min(layers_->first(), path->layer),
                      path->layer);
    const auto& moves = presenter_->waypointsOf(path->layer);
    const auto at = std::find(moves.begin(), moves.end(), *waypoint);
    timeline_->setMove(static_cast<int>(at - moves.begin()) + 1);
  } else if (path && page() == Page::Simulate && presenter_->clock()) {
    if (const auto time = presenter_->clock()->timeOfWaypoint(*waypoint))
      setTime(*time);
  }
  showView();
}

void MainWindow::showChosen(scene::ViewState& view) const {
  const auto plan = planOfLayers();
  const plan::ToolPath* path = plan && chosenWaypoint_ ? pathOf(*plan, *chosenWaypoint_) : nullptr;
  if (!path || !view.paths)
    return;
  view.path = static_cast<std::size_t>(path - plan->paths.data());
  view.marker = plan->position[*chosenWaypoint_];
}

} // namespace voluta::window
