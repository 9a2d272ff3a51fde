// Programs and their report into a folder, in the background.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/outputs.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>

namespace voluta::document {

class Exporting : public QObject {
  Q_OBJECT

public:
  explicit Exporting(QObject* parent = nullptr);

  // Which of the files that write() would leave in the folder are there already, programs first.
  static QStringList inTheWay(const QString& folder, const pipeline::PlanResult& plan,
                              const pipeline::Programs& programs);

  // All of them or none: a file that cannot be written leaves the folder as it was. The folder is
  // made where it is missing. Replaces a write under way.
  void write(const QString& folder, std::shared_ptr<const pipeline::PlanResult> plan,
             pipeline::Programs programs, pipeline::ProofStyle proofStyle = {});

  // Finishes what was broken off there when a window ended amid an export (base/staged_folder.h).
  void finish(const QString& folder);

signals:
  void written(const QString& folder, int files);
  // One line.
  void failed(const QString& message);

private:
  jobs::JobRunner runner_;
  jobs::JobRunner finisher_;
};

} // namespace voluta::document
