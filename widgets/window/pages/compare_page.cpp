#include "window/pages/compare_page.h"

#include "document/comparing.h"
#include "document/planning.h"
#include "pipeline/stage_cache.h"
#include "window/compare_view.h"
#include "window/pages/choices_editor.h"

#include <QScrollArea>
#include <algorithm>

namespace voluta::window {

ComparePage::ComparePage(const Workspace& workspace)
    : Page({"compare", QT_TRANSLATE_NOOP("Commands", "&Compare"), true}, workspace),
      view_(new CompareView(workspace.document, workspace.comparing)),
      side_(scrolled(view_->panel())) {
  view_->setObjectName("comparePage");
  connect(&work().comparing, &document::Comparing::failed, this, [this](const QString& message) {
    work().shell.showMessage(tr("Nothing can be compared"), message);
  });
  connect(
      view_, &CompareView::adopted, this,
      [this](const QString& strategy, const std::shared_ptr<const pipeline::PlanResult>& result) {
        // Plan reuses the results of the comparison.
        if (result)
          pipeline::seedCache(*work().planning.cache(), result->job);
        work().shell.say(tr("Adopted: %1. Press Plan.").arg(strategy));
        work().shell.showStates();
      });
}

QWidget* ComparePage::centre() {
  return view_;
}

PageState ComparePage::state() const {
  const document::Comparing& comparing = work().comparing;
  const auto& rows = comparing.rows();
  const bool any = std::any_of(rows.begin(), rows.end(),
                               [](const auto& row) { return row.compared.has_value(); });
  return comparing.running()        ? PageState::Running
         : !any                     ? PageState::Nothing
         : !comparing.upToDate()    ? PageState::OutOfDate
         : comparing.ranking().best ? PageState::Done
                                    : PageState::Blocked;
}

void ComparePage::retranslate() {
  const forms::ChoiceLists lists = choiceLists();
  view_->setLists(lists.modes, lists.growths, lists.cells);
}

void ComparePage::draw(scene::ViewState& view) {
  view.part = true; // It is not visible
}

} // namespace voluta::window
