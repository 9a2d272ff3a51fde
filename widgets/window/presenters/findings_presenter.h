// Shows the current findings in their panel and on the time-line, and applies their remedies.
#pragma once

#include "panels/findings_panel.h"
#include "pipeline/remedies.h"
#include "plan/finding.h"
#include "window/presenters/remedy_effect.h"

#include <QObject>
#include <optional>
#include <vector>

namespace voluta::document {
class Document;
class LivePreview;
class Planning;
} // namespace voluta::document
namespace voluta::timeline {
class TimelineBar;
}

namespace voluta::window {

class FindingsPresenter : public QObject {
  Q_OBJECT

public:
  // All must outlive this.
  FindingsPresenter(document::Document& document, document::Planning& planning,
                    document::LivePreview& live, panels::FindingsPanel& panel,
                    timeline::TimelineBar& timeline);

private:
  void show();
  // Returns the error that ended a run, if any.
  plan::Findings stopped() const;
  // Reads every cell; cached per finding until the choices change.
  const std::vector<pipeline::RemedyAction>& offersFor(const plan::Finding& finding);
  std::vector<panels::RemedyButton> remediesOf(const plan::Finding& finding);
  void apply(const plan::Finding& finding, const QString& remedy);

  document::Document& document_;
  document::Planning& planning_;
  panels::FindingsPanel& panel_;
  timeline::TimelineBar& timeline_;
  std::vector<pipeline::RemedyAction> offersAnew(plan::Finding finding) const;
  struct Offered {
    plan::FindingKind kind{};
    std::vector<plan::NamedValue> values;
    int item = -1;
    std::vector<pipeline::RemedyAction> offers;
  };
  RemedyEffect effect_;
  std::optional<Offered> offered_; // the last ones, for the present choices
};

} // namespace voluta::window
