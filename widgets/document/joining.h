// Jobs whose machines work in one cell: reads further jobs, plans their work together and writes
// the result, in the background.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/joined_jobs.h"

#include <QObject>
#include <QString>
#include <memory>

namespace voluta::document {

using JoinedResult = std::shared_ptr<const pipeline::TogetherResult>;

class Joining : public QObject {
  Q_OBJECT

public:
  explicit Joining(QObject* parent = nullptr);

  // Reads a project with a motion. Replaces a pending read.
  void read(const QString& file);
  // Replaces a pending plan. Precondition: as of pipeline::planTogether.
  void plan(pipeline::TogetherRequest request);
  bool planning() const { return planner_.running(); }
  // Of the plan; `cancelled` follows.
  void cancel();
  // Writes all outputs and together.json into a folder, all or nothing. Replaces a pending write.
  void write(const QString& folder, JoinedResult result);

signals:
  void jobRead(const QString& file, std::shared_ptr<const voluta::project::Job> job);
  void progressed(double fraction, const QString& stage);
  void planned(const voluta::document::JoinedResult& result);
  void cancelled();
  void written(const QString& folder);
  // One line.
  void failed(const QString& message);

private:
  jobs::JobRunner reader_, planner_, writer_;
};

} // namespace voluta::document
