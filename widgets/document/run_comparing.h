// Compares a recorded run with the present plan, in the background.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/compare_run.h"
#include "pipeline/plan_result.h"

#include <QObject>
#include <QString>
#include <memory>

namespace voluta::document {

class RunComparing : public QObject {
  Q_OBJECT

public:
  explicit RunComparing(QObject* parent = nullptr);

  // Replaces a pending comparison. Precondition: the plan has a motion.
  void compare(const QString& record, std::shared_ptr<const pipeline::PlanResult> plan);

signals:
  void progressed(double fraction);
  void compared(const voluta::pipeline::ComparedRun& run);
  // One line.
  void failed(const QString& message);

private:
  jobs::JobRunner runner_;
};

} // namespace voluta::document
