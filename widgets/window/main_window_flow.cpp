// Opening, closing, running.
#include "window/main_window.h"

#include "window/status_line.h"

#include <QDragEnterEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <algorithm>

namespace voluta::window {

using project::Stage;

void MainWindow::open(const QString& path) {
  const auto start = [this, path] {
    planning_.cancel();
    opening_.open(path);
  };
  // Another part is an edit, which undo takes back; another project is not.
  if (path.endsWith(".voluta", Qt::CaseInsensitive))
    afterSaved(start);
  else
    start();
}

void MainWindow::offerRecovered() {
  const std::vector<document::Recovered> left = document::recoverable();
  if (left.empty())
    return;
  const document::Recovered& latest = left.front();
  QMessageBox box(QMessageBox::Question, tr("Recover unsaved work"),
                  tr("Voluta ended unexpectedly. “%1” was kept on %2.")
                      .arg(latest.name, QLocale().toString(latest.time, QLocale::ShortFormat)),
                  QMessageBox::NoButton, this);
  box.setObjectName("recoverBox");
  QPushButton* recover = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
  QPushButton* discard = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
  box.addButton(tr("Later"), QMessageBox::RejectRole);
  box.exec();
  if (box.clickedButton() == recover) {
    // The copy stays until the document holds it.
    connect(
        &opening_, &document::Opening::opened, autosave_.get(),
        [this, latest] { autosave_->adopt(latest); }, Qt::SingleShotConnection);
    opening_.openRecovered(latest);
  } else if (box.clickedButton() == discard) {
    document::discardRecovered(latest);
  }
}

void MainWindow::afterSaved(std::function<void()> then) {
  if (!document_.dirty()) {
    then();
    return;
  }
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"),
                  tr("“%1” has changes that are not saved.").arg(document_.name()),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setObjectName("unsavedBox");
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (answer == QMessageBox::Discard) {
    then();
  } else if (answer == QMessageBox::Save) {
    afterSave_ = std::move(then);
    save();
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls())
    event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) {
      event->acceptProposedAction();
      open(url.toLocalFile());
      return;
    }
}

void MainWindow::tell(const QString& title, const QString& message) {
  auto* box = new QMessageBox(QMessageBox::Warning, title, message, QMessageBox::Ok, this);
  box->setObjectName("messageBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void MainWindow::plan() {
  if (!document_.source()) {
    chooseFile();
    return;
  }
  if (page() == Page::Prepare || page() == Page::Compare)
    setPage(Page::Layers);
  planning_.plan(Stage::Replay);
}

void MainWindow::setLivePreview(bool on) {
  QSettings().setValue("plan/livePreview", on);
  live_.setEnabled(on);
}

void MainWindow::cancel() {
  if (planning_.running())
    planning_.cancel();
  else if (live_.running())
    live_.cancel();
  else if (opening_.running())
    opening_.cancel();
  else if (comparing_.running())
    comparing_.cancel();
}

QString MainWindow::summaryText() const {
  if (const auto& preview = document_.preview()) {
    const curved::Decomposition& d = *preview->decomposition;
    const QString counts = tr("%1 voxels, %2 missed")
                               .arg(QLocale().toString(static_cast<qulonglong>(d.voxels)),
                                    QLocale().toString(static_cast<qulonglong>(d.missedVoxels)));
    return d.field.empty() ? tr("Preview: %1, %2 growth steps").arg(counts).arg(d.layers)
                           : tr("Preview: %1, layers are being improved").arg(counts);
  }
  const auto result = document_.presentResult();
  if (!result || !result->job.reached || *result->job.reached == Stage::Load)
    return document_.source() ? tr("Ready. Press Plan.") : QString();
  const project::Report& r = result->job.report;
  const QLocale locale;
  QStringList parts;
  const bool ahead = document_.voxelsAhead() && !planning_.running();
  if (r.decomposition.voxels > 0)
    parts << tr("%1 voxels, %2 missed")
                 .arg(
                     locale.toString(static_cast<qulonglong>(r.decomposition.voxels)),
                     locale.toString(static_cast<qulonglong>(r.decomposition.missedAfterSupports)));
  if (r.decomposition.mode == "planar")
    parts << tr("%1 pieces, %2 mm² need support")
                 .arg(r.decomposition.pieces)
                 .arg(locale.toString(r.decomposition.riskyAreaMm2, 'f', 0));
  if (r.layers.count > 0)
    parts << tr("%1 layers").arg(r.layers.count);
  if (r.toolpath.waypoints > 0)
    parts << tr("%1 waypoints").arg(locale.toString(static_cast<qulonglong>(r.toolpath.waypoints)));
  if (r.toolpath.materialMm3 > 0)
    parts << tr("%1 cm³").arg(locale.toString(r.toolpath.materialMm3 / 1000.0, 'f', 1));
  if (r.motion.durationS > 0)
    parts << durationText(r.motion.durationS);
  if (*result->job.reached == Stage::Replay)
    parts << (r.replay.passed ? tr("replay passed") : tr("replay not passed"));
  const QString text = parts.join(", ");
  return ahead ? tr("Preview: %1. Press Plan.").arg(text) : text;
}

// How the run that has just ended went, in a few words: the figures stand beside the page.
QString MainWindow::endText() const {
  const auto result = document_.lastResult();
  if (!result || !result->job.reached || *result->job.reached == Stage::Load)
    return document_.source() ? tr("Ready. Press Plan.") : QString();
  const plan::Findings& findings = result->job.report.findings;
  const auto blocking = std::count_if(findings.begin(), findings.end(),
                                      [](const plan::Finding& f) { return f.blocking; });
  return blocking > 0 ? tr("Done. Findings that block: %1.").arg(blocking) : tr("Done.");
}

} // namespace voluta::window
