#include "window/presenters/remedy_effect.h"

#include "document/document.h"
#include "document/planning.h"
#include "forms/duration_text.h"
#include "language/words.h"
#include "plan/finding_kinds.h"

#include <QLocale>
#include <QUndoStack>
#include <algorithm>
#include <cmath>

namespace voluta::window {

using project::Stage;

namespace {

// Without the line of a program: another plan has other lines.
QString sentence(const plan::Finding& finding) {
  QString text =
      language::words(finding.program.line > 0 ? plan::factOf(finding) : plan::reasonOf(finding));
  if (!text.isEmpty())
    text[0] = text[0].toUpper();
  return text;
}

const plan::Finding* sameKind(const plan::Findings& findings, const plan::Finding& as) {
  const auto found = std::ranges::find_if(findings, [&](const plan::Finding& finding) {
    return finding.kind == as.kind && finding.item == as.item;
  });
  return found == findings.end() ? nullptr : &*found;
}

// Adds "name: before → after" if they look different.
void addLine(QStringList& lines, const QString& name, const QString& before, const QString& after) {
  if (before != after)
    lines << RemedyEffect::tr("%1: %2 → %3").arg(name, before, after);
}

QString percent(double share) {
  return QStringLiteral("%1 %").arg(QLocale().toString(100.0 * share, 'f', 1));
}

QStringList figureLines(const project::Report& before, const project::Report& after) {
  QStringList lines;
  if (before.programs.empty() || after.programs.empty())
    return lines;
  const project::ReplayReport &b = before.replay, &a = after.replay;
  addLine(lines, RemedyEffect::tr("Not covered"), percent(1.0 - b.coveredFraction),
          percent(1.0 - a.coveredFraction));
  addLine(lines, RemedyEffect::tr("Printed in the air"), percent(b.unsupportedFraction),
          percent(a.unsupportedFraction));
  addLine(lines, RemedyEffect::tr("Overfilled"), percent(b.overfillFraction),
          percent(a.overfillFraction));
  addLine(lines, RemedyEffect::tr("Time"), forms::durationText(before.motion.durationS),
          forms::durationText(after.motion.durationS));
  return lines;
}

} // namespace

RemedyEffect::RemedyEffect(document::Document& document, document::Planning& planning,
                           panels::EffectCard& card)
    : document_(document), planning_(planning), card_(card) {
  connect(&card_, &panels::EffectCard::undoWished, this, [this] {
    if (!applied_ || document_.undoStack()->index() != applied_->edit)
      return;
    const auto before = applied_->before;
    end(); // before the edit, which shows the document again
    document_.undoStack()->undo();
    if (before && before->job.reached)
      planning_.plan(*before->job.reached); // most of it is cached
  });
  connect(&card_, &panels::EffectCard::closed, this, &RemedyEffect::end);
  connect(&card_, &panels::EffectCard::languageChanged, this, &RemedyEffect::show);
}

void RemedyEffect::begin(const plan::Finding& finding, const QString& remedy,
                         std::shared_ptr<const pipeline::PlanResult> before) {
  applied_ = Applied{finding, remedy, std::move(before), document_.undoStack()->index()};
  show();
}

void RemedyEffect::end() {
  applied_.reset();
  card_.hide();
}

void RemedyEffect::show() {
  if (!applied_)
    return;
  if (document_.undoStack()->index() != applied_->edit)
    end();
  else
    card_.setEffect(effect());
}

panels::Effect RemedyEffect::effect() const {
  const plan::Finding& finding = applied_->finding;
  panels::Effect effect{tr("Applied: %1").arg(applied_->remedy), {}, forms::Icon::Pending};
  const Stage stage = plan::stageOf(finding);
  const auto now = document_.result(stage);
  if (document_.failure()) {
    effect.sign = forms::Icon::Blocked;
    effect.lines << tr("It cannot be planned this way. Undo it, or try another remedy.");
    return effect;
  }
  if (!now || !document_.upToDate(stage)) {
    effect.lines << (planning_.running() ? tr("The figures follow when the plan is done.")
                                         : tr("Plan to see its effect."));
    return effect;
  }
  const plan::Finding* still = sameKind(now->job.report.findings, finding);
  const QString before = sentence(finding);
  const QString after = still ? sentence(*still) : tr("No longer found");
  effect.sign = !still ? forms::Icon::Good : forms::Icon::Warning;
  if (still && before == after)
    effect.lines << tr("Unchanged: %1").arg(before);
  else
    effect.lines << tr("Before: %1").arg(before) << tr("After: %1").arg(after);
  const auto replayed = document_.result(Stage::Replay);
  if (applied_->before && replayed && document_.upToDate(Stage::Replay))
    effect.lines << figureLines(applied_->before->job.report, replayed->job.report);
  return effect;
}

} // namespace voluta::window
