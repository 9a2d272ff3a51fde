// The Compare page in the window: progress, state, and what adopting a way of building brings.
#include "window/main_window.h"

#include "pipeline/stage_cache.h"
#include "window/compare_page.h"
#include "window/status_line.h"

#include <QScrollArea>
#include <QStackedWidget>
#include <algorithm>

namespace voluta::window {

void MainWindow::buildCompare() {
  compare_ = new ComparePage(document_, comparing_, this);
  compare_->setObjectName("comparePage");
  compare_->setDark(appearance_ == Appearance::Dark);
  centre_->addWidget(compare_);
  pages_->addWidget(scrolled(compare_->panel()));

  connect(&comparing_, &document::Comparing::started, this, &MainWindow::showStates);
  connect(&comparing_, &document::Comparing::progressed, this,
          [this](const jobs::Progress& progress) {
            if (!planning_.running() && !live_.running() && !opening_.running())
              status_->showProgress(progress);
          });
  connect(&comparing_, &document::Comparing::failed, this,
          [this](const QString& message) { tell(tr("Nothing can be compared"), message); });
  // Queued: while it tells how it ended it is still at it.
  connect(
      &comparing_, &document::Comparing::ended, this,
      [this] {
        if (!planning_.running() && !live_.running())
          status_->showIdle(tr("Compared. Select a row to adopt it."));
        showStates();
      },
      Qt::QueuedConnection);
  connect(compare_, &ComparePage::adopted, this,
          [this](const QString& way, const std::shared_ptr<const pipeline::PlanResult>& result) {
            // Plan goes on from what the comparison has made.
            if (result)
              pipeline::seedCache(*planning_.cache(), result->job);
            status_->showIdle(tr("Adopted: %1. Press Plan.").arg(way));
            showStates();
          });
}

void MainWindow::showCompareState() {
  const auto& rows = comparing_.rows();
  const bool any = std::any_of(rows.begin(), rows.end(),
                               [](const auto& row) { return row.compared.has_value(); });
  flow_->setState(Page::Compare, comparing_.running()        ? PageState::Running
                                 : !any                      ? PageState::Nothing
                                 : !comparing_.upToDate()    ? PageState::OutOfDate
                                 : comparing_.ranking().best ? PageState::Done
                                                             : PageState::Blocked);
}

} // namespace voluta::window
