// The effect of the remedy applied last, on the card above the findings: the finding and the
// figures of the print before and after the new plan.
#pragma once

#include "panels/effect_card.h"
#include "pipeline/plan_result.h"
#include "plan/finding.h"

#include <QObject>
#include <memory>
#include <optional>

namespace voluta::document {
class Document;
class Planning;
} // namespace voluta::document

namespace voluta::window {

class RemedyEffect : public QObject {
  Q_OBJECT

public:
  // All must outlive this.
  RemedyEffect(document::Document& document, document::Planning& planning,
               panels::EffectCard& card);

  // To be called after the remedy's edit. `before`: the plan with the finding.
  void begin(const plan::Finding& finding, const QString& remedy,
             std::shared_ptr<const pipeline::PlanResult> before);
  // To be called after every change of the document. Another edit, or undo, ends it.
  void show();

private:
  struct Applied {
    plan::Finding finding;
    QString remedy;
    std::shared_ptr<const pipeline::PlanResult> before;
    int edit = 0; // index of the undo stack after it
  };
  void end();
  panels::Effect effect() const;

  document::Document& document_;
  document::Planning& planning_;
  panels::EffectCard& card_;
  std::optional<Applied> applied_;
};

} // namespace voluta::window
