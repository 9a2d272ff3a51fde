// Verifies a program from disk against the present plan, in the background.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/road.h"

#include <QObject>
#include <QString>
#include <memory>

namespace voluta::document {

class Verifying : public QObject {
  Q_OBJECT

public:
  explicit Verifying(QObject* parent = nullptr);

  // Replaces a pending verification. Precondition: the plan has a motion.
  void verify(const QString& program, std::shared_ptr<const pipeline::PlanResult> plan);
  // Emits nothing.
  void cancel() { runner_.cancel(); }

signals:
  void progressed(double fraction);
  void verified(const voluta::pipeline::VerifyResult& result);
  // One line.
  void failed(const QString& message);

private:
  jobs::JobRunner runner_;
};

} // namespace voluta::document
