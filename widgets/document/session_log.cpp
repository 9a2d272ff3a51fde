#include "document/session_log.h"

#include "base/error.h"
#include "document/document.h"
#include "document/opening.h"
#include "document/planning.h"
#include "project/version.h"

#include <QFileInfo>
#include <QStandardPaths>
#include <QSysInfo>
#include <algorithm>

namespace voluta::document {

using base::LogLevel;

QString logFile() {
  const QString chosen = qEnvironmentVariable("VOLUTA_STATE_DIR");
  return (chosen.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)
                           : chosen) +
         QStringLiteral("/voluta.log");
}

namespace {
base::Log opened(const QString& file) {
  try {
    return base::Log(file.toStdString());
  } catch (const base::Error&) {
    return {};
  }
}

QString nameOf(const QString& path) {
  return QFileInfo(path).fileName();
}

QString wordOf(project::Stage stage) {
  const std::string_view name = project::stageName(stage);
  return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

double secondsOf(const QElapsedTimer& clock) {
  return clock.isValid() ? static_cast<double>(clock.elapsed()) / 1000.0 : 0.0;
}
} // namespace

SessionLog::SessionLog(const QString& file, Document& document, Planning& planning,
                       Opening& opening, QObject* parent)
    : QObject(parent), log_(opened(file)), document_(document) {
  note(QStringLiteral("voluta %1, Qt %2, %3, %4")
           .arg(QLatin1String(project::kVersion), QLatin1String(qVersion()),
                QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture()));
  listenToOpening(opening);
  listenToPlanning(planning);
}

void SessionLog::note(const QString& line) const {
  log_.write(LogLevel::Info, line.toStdString());
}

void SessionLog::listenToOpening(Opening& opening) {
  connect(&opening, &Opening::opened, this,
          [this](const QString& path) { note("opened " + nameOf(path)); });
  connect(&opening, &Opening::repaired, this, [this] { note("repaired"); });
  connect(&opening, &Opening::failed, this, [this](const QString& path, const QString& message) {
    log_.write(LogLevel::Error, ("cannot open " + nameOf(path) + ": " + message).toStdString());
  });
}

void SessionLog::listenToPlanning(Planning& planning) {
  connect(&planning, &Planning::started, this, [this](project::Stage until) {
    sinceStart_.start();
    sinceStage_.start();
    note(QStringLiteral("plans up to %1").arg(wordOf(until)));
  });
  connect(&planning, &Planning::stageDone, this, &SessionLog::noteStage);
  connect(&planning, &Planning::finished, this, [this] {
    note(QStringLiteral("planned in %1 s").arg(secondsOf(sinceStart_), 0, 'f', 2));
    noteFindings();
  });
  connect(&planning, &Planning::cancelled, this, [this] {
    note(QStringLiteral("cancelled after %1 s").arg(secondsOf(sinceStart_), 0, 'f', 2));
  });
  connect(&planning, &Planning::failed, this, [this](project::Stage stage, const QString& message) {
    log_.write(LogLevel::Error, (wordOf(stage) + " failed: " + message).toStdString());
  });
}

void SessionLog::noteStage(project::Stage stage) {
  note(QStringLiteral("%1: %2 s").arg(wordOf(stage)).arg(secondsOf(sinceStage_), 0, 'f', 2));
  sinceStage_.restart();
}

void SessionLog::noteFindings() const {
  const auto result = document_.lastResult();
  if (!result)
    return;
  const plan::Findings& findings = result->job.report.findings;
  const auto blocking = std::count_if(findings.begin(), findings.end(),
                                      [](const plan::Finding& f) { return f.blocking; });
  note(QStringLiteral("%1 findings, %2 of them blocking").arg(findings.size()).arg(blocking));
}

} // namespace voluta::document
