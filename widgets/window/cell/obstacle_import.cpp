#include "window/cell/obstacle_import.h"

#include "base/error.h"
#include "base/outcome.h"
#include "cells/obstacle_file.h"
#include "forms/file_patterns.h"
#include "language/numbers.h"
#include "language/words.h"
#include "window/background.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>
#include <QWidget>

namespace voluta::window {

namespace {

constexpr double kTinyMm = 10.0; // Shorter meshes are no obstacles
constexpr double kMmInMetre = 1000.0;

} // namespace

ObstacleImport::ObstacleImport(QWidget* parent) : QObject(parent), parent_(parent) {}

void ObstacleImport::choose() {
  const QString key = QStringLiteral("open/folder");
  const QString file = QFileDialog::getOpenFileName(
      parent_, tr("Obstacle from a file"), QSettings().value(key).toString(),
      tr("Meshes (%1);;All files (*)").arg(forms::filePatterns(project::NamedFiles::AllMeshes)));
  if (file.isEmpty())
    return;
  QSettings().setValue(key, QFileInfo(file).absolutePath());
  emit started(QFileInfo(file).fileName());
  read(file, 1.0);
}

void ObstacleImport::read(const QString& path, double mmPerUnit) {
  inBackground(
      runner_,
      [file = std::filesystem::path(path.toStdString()), mmPerUnit](const base::RunContext& ctx) {
        return base::outcomeOf([&] { return cells::obstacleOfFile(file, mmPerUnit, ctx); });
      },
      [this, path, mmPerUnit](base::Outcome<cells::ObstacleSolids>&& outcome) {
        const QString name = QFileInfo(path).completeBaseName();
        if (const auto* error = std::get_if<base::Error>(&outcome))
          emit failed(language::words(error->whole()));
        const auto* read = std::get_if<cells::ObstacleSolids>(&outcome);
        if (!read)
          return;
        if (mmPerUnit == 1.0 && read->longestMm < kTinyMm && drawnInMetres(name, read->longestMm))
          this->read(path, kMmInMetre);
        else
          emit imported(name, read->solids);
      });
}

bool ObstacleImport::drawnInMetres(const QString& name, double longestMm) {
  return QMessageBox::question(parent_, parent_->windowTitle(),
                               tr("%1 is %2 mm long. Was it drawn in metres?")
                                   .arg(name, language::numberText(longestMm, 3))) ==
         QMessageBox::Yes;
}

} // namespace voluta::window
