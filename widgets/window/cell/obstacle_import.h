// Lets the user choose a mesh file and converts it in the background to solids for an obstacle.
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
  // Dialogs are shown over `parent`.
  explicit ObstacleImport(QWidget* parent);

  // Shows the file dialog; does nothing if no file is chosen.
  void choose();
  bool running() const { return runner_.running(); }

signals:
  void started(const QString& file);
  // `name`: of the file, without folder and extension.
  void imported(const QString& name, const std::vector<voluta::robot::Shape>& solids);
  void failed(const QString& why);

private:
  void read(const QString& path, double mmPerUnit);
  bool drawnInMetres(const QString& name, double longestMm);

  QWidget* parent_;
  jobs::JobRunner runner_;
};

} // namespace voluta::window
