// Writes programs and their report into a folder, in the background.
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

  // Returns the files that write() would write and that already exist in the folder, programs
  // first.
  static QStringList conflictingFiles(const QString& folder, const pipeline::PlanResult& plan,
                                      const pipeline::Programs& programs);

  // Writes all files or none: if one cannot be written, the folder is left unchanged. Creates the
  // folder if it is missing. Replaces a pending write.
  void write(const QString& folder, std::shared_ptr<const pipeline::PlanResult> plan,
             pipeline::Programs programs, pipeline::ProofStyle proofStyle = {});

  // Completes an export that was interrupted by the end of the program (base/staged_folder.h).
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
