#include "window/pages/simulate_page.h"

#include "document/document.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "robot/cell.h"
#include "timeline/joint_plots.h"
#include "timeline/layer_range_slider.h"
#include "window/pages/cell_view.h"
#include "window/presenter.h"

#include <QScrollArea>
#include <algorithm>

namespace voluta::window {

using project::Stage;

SimulatePage::SimulatePage(const Workspace& workspace)
    : Page({"simulate", QT_TRANSLATE_NOOP("Commands", "&Simulate")}, workspace),
      plots_(new timeline::JointPlots) {
  plots_->setObjectName("plots");
  side_ = scrolled(plots_);
  side_->setObjectName("plotsArea"); // may be tight: it is scrolled
  timeline::TimelineBar* bar = &work().timeline;
  connect(bar, &timeline::TimelineBar::timeChanged, plots_, &timeline::JointPlots::setTimeS);
  connect(plots_, &timeline::JointPlots::timeClicked, bar, &timeline::TimelineBar::setTimeS);
  connect(&work().presenter, &Presenter::motionReady, this, &SimulatePage::showMotion);
}

void SimulatePage::showMotion() {
  const auto& clock = work().presenter.clock();
  std::vector<robot::JointLimits> limits;
  std::vector<robot::ExternalAxis> externalAxes;
  if (const auto motion = work().document.result(Stage::Motion); motion && motion->cell) {
    limits = motion->cell->limits();
    externalAxes = motion->cell->externalAxes();
  }
  plots_->setTrajectory(clock ? clock->trajectory() : nullptr, std::move(limits),
                        std::move(externalAxes));
}

void SimulatePage::draw(scene::ViewState& view) {
  drawCellAtWork(view, work());
}

std::optional<Laid> SimulatePage::laid() const {
  Laid laid;
  if (const auto& clock = work().presenter.clock(); clock && !clock->empty())
    laid.end = clock->printedWaypoints(work().timeline.timeS());
  const auto plan = planOfLayers(work().document);
  const plan::ToolPath* path =
      plan ? plan::pathOf(*plan, std::max<std::size_t>(laid.end, 1) - 1) : nullptr;
  laid.layer = path ? path->layer : work().layers.last();
  return laid;
}

void SimulatePage::goToTimeOf(std::size_t waypoint) {
  if (!work().presenter.clock())
    return;
  if (const auto time = work().presenter.clock()->timeOfWaypoint(waypoint))
    work().timeline.setTimeS(*time);
}

void SimulatePage::goToWaypoint(const plan::ToolPath&, std::size_t waypoint) {
  goToTimeOf(waypoint);
}

int SimulatePage::interest(const plan::Finding& finding) const {
  if (!work().presenter.clock())
    return 0;
  if (finding.whenS)
    return 3;
  return plan::stageOf(finding) == Stage::Motion || plan::stageOf(finding) == Stage::Replay ? 2 : 0;
}

bool SimulatePage::goTo(const plan::Finding& finding) {
  if (finding.whenS)
    work().timeline.setTimeS(*finding.whenS);
  return false;
}

void SimulatePage::clicked(const std::optional<scene::Hit>& hit) {
  if (!hit || hit->what != scene::Hit::What::Path || !work().presenter.clock())
    return;
  goToTimeOf(hit->waypoint);
  work().shell.chooseWaypoint(hit->waypoint);
}

} // namespace voluta::window
