#include "window/runs.h"

#include "base/data_files.h"
#include "curved/decomposition.h"
#include "forms/duration_text.h"
#include "modes/mode_table.h"
#include "panels/listed_findings.h"
#include "pipeline/plan_verdict.h"
#include "project/report.h"
#include "window/quote/quote.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QCoreApplication>
#include <QLineEdit>
#include <QLocale>
#include <QSettings>
#include <algorithm>

namespace voluta::window {

using project::Stage;

namespace {
constexpr const char* kLivePreview = "plan/livePreview";

// Commits a number that is being typed, as leaving its field would.
void commitTyping() {
  QWidget* field = QApplication::focusWidget();
  if (!qobject_cast<QAbstractSpinBox*>(field) && !qobject_cast<QLineEdit*>(field))
    return;
  field->clearFocus();
  field->setFocus();
}

QString voxelsText(std::size_t voxels, std::size_t missed) {
  const QLocale locale;
  const QString lost = locale.toString(static_cast<qulonglong>(missed));
  return voxels == 1 ? Runs::tr("1 voxel, %1 missed").arg(lost)
                     : Runs::tr("%1 voxels, %2 missed")
                           .arg(locale.toString(static_cast<qulonglong>(voxels)), lost);
}

// Sums over all parts.
struct ItemTotals {
  std::size_t voxels = 0, missed = 0;
  bool cuts = false; // any part is cut into pieces
  int pieces = 0, layers = 0;
  double riskyAreaMm2 = 0.0;
};

ItemTotals totalsOf(const project::Report& report) {
  ItemTotals all;
  for (const project::ItemReport& item : report.items) {
    all.voxels += item.decomposition.voxels;
    all.missed += item.decomposition.missedAfterSupports;
    all.layers += item.layers.count;
    const modes::Mode* mode = modes::modeNamed(item.decomposition.mode);
    if (!mode || !mode->cuts)
      continue;
    all.cuts = true;
    all.pieces += item.decomposition.pieces;
    all.riskyAreaMm2 += item.decomposition.riskyAreaMm2;
  }
  return all;
}

QString verdictText(const project::Report& report) {
  switch (pipeline::verdictOf(report)) {
  case pipeline::PlanVerdict::Passed:
    return Runs::tr("replay passed");
  case pipeline::PlanVerdict::NotAsAsked:
    return Runs::tr("safe to run, not as asked");
  case pipeline::PlanVerdict::Unchecked:
    return Runs::tr("safe to run but for your own statements");
  case pipeline::PlanVerdict::Blocked:
    return Runs::tr("not passed: blocking findings");
  case pipeline::PlanVerdict::Refused:
    break;
  }
  return Runs::tr("replay not passed");
}

QString figuresText(const project::Report& r, Stage reached) {
  const QLocale locale;
  QStringList parts;
  const ItemTotals all = totalsOf(r);
  if (r.items.size() > 1)
    parts << Runs::tr("%1 parts").arg(r.items.size());
  if (all.voxels > 0)
    parts << voxelsText(all.voxels, all.missed);
  if (all.cuts)
    parts << (all.pieces == 1 ? Runs::tr("1 piece") : Runs::tr("%1 pieces").arg(all.pieces))
          << Runs::tr("%1 mm² need support").arg(locale.toString(all.riskyAreaMm2, 'f', 0));
  if (all.layers > 0)
    parts << (all.layers == 1 ? Runs::tr("1 layer") : Runs::tr("%1 layers").arg(all.layers));
  if (r.toolpath.waypoints > 0)
    parts << (r.toolpath.waypoints == 1
                  ? Runs::tr("1 waypoint")
                  : Runs::tr("%1 waypoints")
                        .arg(locale.toString(static_cast<qulonglong>(r.toolpath.waypoints))));
  if (r.toolpath.materialMm3 > 0)
    parts << Runs::tr("%1 cm³").arg(locale.toString(r.toolpath.materialMm3 / 1000.0, 'f', 1));
  if (r.motion.toolChanges > 0)
    parts << (r.motion.toolChanges == 1 ? Runs::tr("1 tool change")
                                        : Runs::tr("%1 tool changes").arg(r.motion.toolChanges));
  if (r.motion.durationS > 0)
    parts << Runs::tr("planned time %1").arg(forms::durationText(r.motion.durationS));
  if (r.replay.controllerDurationS > 0)
    parts << Runs::tr("time on the controller %1")
                 .arg(forms::durationText(r.replay.controllerDurationS));
  if (reached == Stage::Replay)
    parts << verdictText(r);
  return parts.join(", ");
}

// Returns nullptr if the result has no stage after Load.
std::shared_ptr<const pipeline::PlanResult>
planned(const std::shared_ptr<const pipeline::PlanResult>& result) {
  return result && result->job.reached && *result->job.reached != Stage::Load ? result : nullptr;
}

QString invitation(const document::Document& document) {
  return document.unusable() ? Runs::tr("Cannot plan: correct the marked setting.")
         : document.source() ? Runs::tr("Ready. Press Plan.")
                             : QString();
}

// Returns a short summary of the run that has just ended; the figures are shown next to the page.
QString endText(const document::Document& document) {
  const auto result = planned(document.lastResult());
  if (!result)
    return invitation(document);
  const std::vector<panels::ListedFinding> findings = panels::listed(result->job.report.findings);
  const auto blocking =
      std::count_if(findings.begin(), findings.end(),
                    [](const panels::ListedFinding& row) { return row.finding.blocking; });
  if (!result->job.report.programs.empty()) {
    const pipeline::PlanVerdict verdict = pipeline::verdictOf(result->job.report);
    if (verdict == pipeline::PlanVerdict::NotAsAsked)
      return Runs::tr("Done. Safe to run, not as asked: %1.").arg(blocking);
    if (verdict == pipeline::PlanVerdict::Unchecked)
      return Runs::tr("Done. Safe to run but for your own statements.");
  }
  return blocking > 0 ? Runs::tr("Done. Blocking findings: %1.").arg(blocking) : Runs::tr("Done.");
}

QString cancelText(const document::Document& document) {
  return planned(document.lastResult())
             ? Runs::tr("Cancelled. The previous results are still shown.")
         : document.source() ? Runs::tr("Cancelled. Press Plan to start again.")
                             : QString(); // opening it was undone
}

QString previewEndText(const document::Document& document) {
  const auto result = document.itemResult(Stage::Decompose);
  return result && result->job.item().pieces()
             ? Runs::tr("Pieces updated. Press Plan for layers and paths.")
         : result && result->job.item().decomposition()
             ? Runs::tr("Voxels updated. Press Plan for layers and paths.")
             : Runs::tr("Press Plan for layers and paths.");
}
} // namespace

Runs::Runs(document::Document& document, document::Planning& planning, document::LivePreview& live,
           document::Comparing& comparing, document::Opening& opening)
    : document_(document), planning_(planning), live_(live), comparing_(comparing),
      opening_(opening) {
  planning_.setStartsOver(true);
  live_.setEnabled(QSettings().value(kLivePreview, true).toBool());
  listenToPlanning();
  listenToPreview();
  listenToOthers();
}

void Runs::listenToPlanning() {
  using document::Planning;
  connect(&planning_, &Planning::started, this, &Runs::changed);
  connect(&planning_, &Planning::progressed, this, &Runs::progressed);
  connect(&planning_, &Planning::finished, this, [this] {
    emit said(endText(document_));
    emit changed();
  });
  connect(&planning_, &Planning::cancelled, this, [this] {
    emit changed();
    emit said(cancelText(document_));
  });
  connect(&planning_, &Planning::failed, this, [this] {
    emit changed();
    emit said(tr("The run failed: see the findings."));
  });
  connect(&document_, &document::Document::edited, this, [this] {
    if (document_.unusable())
      emit said(invitation(document_));
    layPart();
  });
  // The document may have been edited just before the run ended. Queued, as the run is still
  // emitting its end.
  connect(
      &planning_, &Planning::finished, this,
      [this] {
        if (!document_.key(Stage::Load).empty() && !document_.upToDate(Stage::Load))
          layPart();
      },
      Qt::QueuedConnection);
}

// The first stage is quick: run it automatically, so that the part is shown at its placement.
void Runs::layPart() {
  if (!planning_.running() && document_.source() && document_.sourceReady() &&
      !document_.unusable())
    planning_.plan(Stage::Load);
}

void Runs::listenToPreview() {
  using document::LivePreview;
  connect(&live_, &LivePreview::started, this, &Runs::changed);
  connect(&live_, &LivePreview::progressed, this, &Runs::progressed);
  connect(&live_, &LivePreview::finished, this, [this] {
    emit said(previewEndText(document_));
    emit changed();
  });
  connect(&live_, &LivePreview::cancelled, this, [this] {
    emit said(cancelText(document_));
    emit changed();
  });
  connect(&live_, &LivePreview::failed, this, [this] {
    emit said(tr("The run failed: see the findings."));
    emit changed();
  });
}

void Runs::listenToOthers() {
  using document::Comparing;
  using document::Opening;
  connect(&comparing_, &Comparing::started, this, &Runs::changed);
  connect(&comparing_, &Comparing::progressed, this, [this](const jobs::Progress& progress) {
    if (!planning_.running() && !live_.running() && !opening_.running())
      emit progressed(progress);
  });
  connect(&opening_, &Opening::started, this, &Runs::changed);
  connect(&opening_, &Opening::progressed, this, &Runs::progressed);
  // Queued: while they emit their end they still count as running.
  connect(
      &comparing_, &Comparing::ended, this,
      [this] {
        if (!planning_.running() && !live_.running())
          emit said(tr("Compared. Select a row to adopt it."));
        emit changed();
      },
      Qt::QueuedConnection);
  connect(&opening_, &Opening::opened, this, &Runs::changed, Qt::QueuedConnection);
  connect(&opening_, &Opening::repaired, this, &Runs::changed, Qt::QueuedConnection);
  connect(&opening_, &Opening::cancelled, this, &Runs::changed, Qt::QueuedConnection);
  connect(&opening_, &Opening::failed, this, &Runs::changed, Qt::QueuedConnection);
}

std::vector<Command> Runs::commands() {
  const auto part = [this] { return document_.source() && !document_.unusable(); };
  return {
      {"plan",
       "runMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&Plan"),
       QT_TRANSLATE_NOOP("Commands", "From the part to verified robot programs"),
       {QKeySequence("Ctrl+R")},
       [this] { askForPlan(Stage::Replay); },
       part,
       {},
       "plan",
       BarGroup::Run,
       [this] {
         return QCoreApplication::translate("Commands",
                                            hasPlanned() ? QT_TRANSLATE_NOOP("Commands", "E&xport…")
                                                         : QT_TRANSLATE_NOOP("Commands", "&Plan"));
       },
       [this] { return hasPlanned() ? "export" : "plan"; }},
      {"planLayers",
       "runMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "Plan up to the &layers"),
       QT_TRANSLATE_NOOP("Commands", "Stops before tool-paths and motion"),
       {QKeySequence("Ctrl+L")},
       [this] { askForPlan(Stage::Layers); },
       part},
      {"cancel",
       "runMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&Cancel"),
       QT_TRANSLATE_NOOP("Commands", "Stop; the last results stay visible"),
       {QKeySequence("Ctrl+.")},
       [this] { cancel(); },
       [this] { return busy(); },
       {},
       "cancel",
       BarGroup::Run},
      {"livePreview",
       "runMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&Update voxels while editing"),
       QT_TRANSLATE_NOOP("Commands",
                         "After the first plan, voxels follow the settings; layers and paths "
                         "wait for Plan"),
       {},
       [this] {
         live_.setEnabled(!live_.enabled());
         QSettings().setValue(kLivePreview, live_.enabled());
       },
       {},
       [this] { return live_.enabled(); }},
  };
}

bool Runs::hasPlanned() const {
  return document_.source() && !document_.unusable() && !planning_.running() &&
         document_.upToDate(Stage::Replay);
}

QString Runs::headline() const {
  const auto result = planned(document_.presentResult());
  if (!result || !result->job.trajectory || !document_.upToDate(*result->job.reached))
    return {};
  if (quoted_.lock() != result) {
    quoted_ = result;
    quote_ = quoteOf(*result, {});
  }
  if (!quote_)
    return {};
  quote_->prices = quotePrices(base::dataName(result->job.choices.cell));
  return quoteText(*quote_);
}

void Runs::askForPlan(Stage until) {
  commitTyping();
  emit planAsked(until);
}

bool Runs::busy() const {
  return planning_.running() || opening_.running() || live_.running() || comparing_.running();
}

void Runs::cancel() {
  if (planning_.running())
    planning_.cancel();
  else if (live_.running())
    live_.cancel();
  else if (opening_.running())
    opening_.cancel();
  else if (comparing_.running())
    comparing_.cancel();
}

void Runs::cancelAll() {
  planning_.cancel();
  live_.cancel();
  comparing_.cancel();
  opening_.cancel();
}

QString Runs::summary() const {
  if (const auto& preview = document_.preview()) {
    const curved::Decomposition& d = *preview->decomposition;
    const QString counts = voxelsText(d.voxels, d.missedVoxels);
    return !d.field.empty() ? tr("Preview: %1, improving layers").arg(counts)
           : d.layers == 1  ? tr("Preview: %1, 1 growth step").arg(counts)
                            : tr("Preview: %1, %2 growth steps").arg(counts).arg(d.layers);
  }
  if (document_.unusable())
    return invitation(document_);
  const auto result = planned(document_.presentResult());
  const QString figures =
      result ? figuresText(result->job.report, *result->job.reached) : QString();
  if (figures.isEmpty())
    return invitation(document_);
  if (!document_.upToDate(*result->job.reached))
    return tr("Out of date: %1").arg(figures);
  return document_.voxelsAhead() && !planning_.running()
             ? tr("Preview: %1. Press Plan.").arg(figures)
             : figures;
}

} // namespace voluta::window
