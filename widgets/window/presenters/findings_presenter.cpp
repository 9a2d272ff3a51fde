#include "window/presenters/findings_presenter.h"

#include "document/dated_findings.h"
#include "document/document.h"
#include "document/live_preview.h"
#include "document/planning.h"
#include "document/shown_names.h"
#include "language/words.h"
#include "pipeline/remedies.h"
#include "plan/finding_kinds.h"
#include "timeline/timeline_bar.h"

#include <algorithm>

namespace voluta::window {

using project::Stage;

FindingsPresenter::FindingsPresenter(document::Document& document, document::Planning& planning,
                                     document::LivePreview& live, panels::FindingsPanel& panel,
                                     timeline::TimelineBar& timeline)
    : document_(document), planning_(planning), panel_(panel), timeline_(timeline),
      effect_(document, planning, panel.effect()) {
  panel_.setRemedies([this](const plan::Finding& finding) { return remediesOf(finding); });
  connect(&panel_, &panels::FindingsPanel::remedyChosen, this, &FindingsPresenter::apply);
  connect(&document, &document::Document::choicesChanged, this, [this] { offered_.reset(); });
  connect(&document, &document::Document::resultChanged, this, &FindingsPresenter::show);
  connect(&document, &document::Document::previewChanged, this, &FindingsPresenter::show);
  connect(&document, &document::Document::edited, this, &FindingsPresenter::show);
  connect(&planning, &document::Planning::failed, this, &FindingsPresenter::show);
  connect(&planning, &document::Planning::started, this, &FindingsPresenter::show);
  connect(&planning, &document::Planning::cancelled, this, &FindingsPresenter::show);
  connect(&live, &document::LivePreview::failed, this, &FindingsPresenter::show);
}

void FindingsPresenter::show() {
  effect_.show();
  const auto result = document_.lastResult();
  panel_.setPlanned(document_.preview() ||
                    (result && result->job.reached && *result->job.reached > Stage::Load));
  panel_.setUnchecked(document::uncheckedStages(document_));
  plan::Findings now = stopped(), before;
  for (document::DatedFinding& dated : document::datedFindings(document_))
    (dated.outOfDate ? before : now).push_back(std::move(dated.finding));
  const auto parts = document_.sources();
  panel_.setParts(parts.size() > 1 ? document::shownNames(parts) : QStringList());
  panel_.setFindings(now, before, result && !result->job.report.programs.empty());
  std::vector<timeline::Mark> marks;
  if (result)
    for (const plan::Finding& finding : result->job.report.findings)
      if (finding.whenS)
        marks.push_back({*finding.whenS, plan::blocksRunning(finding),
                         language::words(plan::reasonOf(finding))});
  timeline_.setMarks(std::move(marks));
}

plan::Findings FindingsPresenter::stopped() const {
  plan::Findings findings;
  if (const document::Failure* failure = document_.failure()) {
    findings.push_back(plan::stoppedFinding(failure->stage, failure->error.whole()));
  }
  return findings;
}

// For a finding about one of several parts, as if that part were alone.
std::vector<pipeline::RemedyAction> FindingsPresenter::offersAnew(plan::Finding finding) const {
  const project::Choices& job = document_.jobChoices();
  if (finding.item < 0 || finding.item >= static_cast<int>(job.items.size()))
    return pipeline::remediesFor(finding, job);
  const project::Choices own = project::onlyItem(job, static_cast<std::size_t>(finding.item));
  finding.item = -1;
  return pipeline::remediesFor(finding, own);
}

const std::vector<pipeline::RemedyAction>&
FindingsPresenter::offersFor(const plan::Finding& finding) {
  if (!offered_ || offered_->kind != finding.kind || offered_->values != finding.values ||
      offered_->item != finding.item)
    offered_ = Offered{finding.kind, finding.values, finding.item, offersAnew(finding)};
  return offered_->offers;
}

std::vector<panels::RemedyButton> FindingsPresenter::remediesOf(const plan::Finding& finding) {
  std::vector<panels::RemedyButton> buttons;
  for (const pipeline::RemedyAction& offer : offersFor(finding)) {
    const std::string_view id = offer.remedy->name;
    buttons.push_back({QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size())),
                       language::words(offer.label), language::words(offer.remedy->help)});
  }
  return buttons;
}

void FindingsPresenter::apply(const plan::Finding& finding, const QString& remedy) {
  // A copy, because the edit below replaces offered_ for the new choices.
  const std::vector<pipeline::RemedyAction> offers = offersFor(finding);
  for (const pipeline::RemedyAction& offer : offers) {
    if (remedy.toStdString() != offer.remedy->name)
      continue;
    const auto before = document_.lastResult();
    if (finding.item >= 0)
      document_.setActive(static_cast<std::size_t>(finding.item));
    if (finding.item >= 0 || document_.partCount() < 2)
      document_.setChoices(offer.choices, language::words(offer.label));
    else
      document_.setJobChoices(offer.choices, language::words(offer.label));
    effect_.begin(finding, language::words(offer.label), before);
    const auto reached = before ? before->job.reached.value_or(Stage::Layers) : Stage::Layers;
    planning_.plan(std::max(Stage::Layers, reached));
    return;
  }
}

} // namespace voluta::window
