// A mesh's file, chosen by the user, read in the background into solids for an obstacle.
#pragma once

#include "jobs/job_runner.h"
#include "robot/body.h"

#include <QObject>
#include <QString>
#include <vector>

class QWidget;

namespace voluta::window {

class ObstacleImport : public QObject {
  Q_OBJECT

public:
  // What it asks the user is asked over `parent`.
  explicit ObstacleImport(QWidget* parent);

  // Asks for a file; nothing happens without one.
  void choose();
  bool running() const { return runner_.running(); }

signals:
  void started(const QString& file);
  // `name`: of the file, without its folder and ending.
  void imported(const QString& name, const std::vector<voluta::robot::Shape>& solids);
  void failed(const QString& why);

private:
  void read(const QString& path, double mmPerUnit);
  bool drawnInMetres(const QString& name, double longestMm);

  QWidget* parent_;
  jobs::JobRunner runner_;
};

} // namespace voluta::window
