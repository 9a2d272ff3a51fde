// The machines of a station: reads further projects, plans the machines' work together and writes
// the result, in the background.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/station_plan.h"

#include <QObject>
#include <QString>
#include <memory>

namespace voluta::document {

using JoinedResult = std::shared_ptr<const pipeline::StationResult>;

class Joining : public QObject {
  Q_OBJECT

public:
  explicit Joining(QObject* parent = nullptr);

  // Reads the project of a job or of a station, whose jobs have motions. Replaces a pending read.
  void read(const QString& file);
  // Replaces a pending plan. Precondition: as of pipeline::planStation.
  void plan(project::Station station);
  bool planning() const { return planner_.running(); }
  // Of the plan; `cancelled` follows.
  void cancel();
  // Writes all outputs and the project of the station into a folder, all or nothing. Replaces a
  // pending write.
  void write(const QString& folder, JoinedResult result);

signals:
  void stationRead(const QString& file, std::shared_ptr<const voluta::project::Station> station);
  void progressed(double fraction, const QString& stage);
  void planned(const voluta::document::JoinedResult& result);
  void cancelled();
  void written(const QString& folder);
  // One line.
  void failed(const QString& message);

private:
  pipeline::StageCache cache_;
  jobs::JobRunner reader_, planner_, writer_; // they use the cache
};

} // namespace voluta::document
