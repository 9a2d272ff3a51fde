// Plans a document in the background and brings the results in, stage by stage.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/road.h"

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

class QTimer;

namespace voluta::pipeline {
class StageCache;
}

namespace voluta::document {

class Document;

// What is told while mode auto tries `way`: its name too, and how long it takes for the last way
// only. An earlier one may be the last that is planned, or end at once.
jobs::Progress progressOfWay(jobs::Progress progress, const pipeline::WayInTurn& way);

// Results stay on show, marked out of date, until newer ones replace them; a cancel or an error
// leaves the last ones. Only what changed is computed again.
class Planning : public QObject {
  Q_OBJECT

public:
  // `document` outlives this.
  explicit Planning(Document& document, QObject* parent = nullptr);
  ~Planning() override;

  // Starts, or starts over. While the part is still being repaired it waits for that. Without a
  // part nothing happens.
  void plan(project::Stage until = project::Stage::Replay);
  // The window is free when this returns.
  void cancel();
  bool running() const;
  // On: a change of the document while a run is under way starts it over (0.3 s after the last
  // change). Off, as at first: the run goes on and its results arrive out of date.
  void setStartsOver(bool on) { startsOver_ = on; }

  // Where the run under way, or the last one, ends.
  project::Stage until() const { return until_; }
  // Kept results, to be seeded from an opened project; good for any thread.
  const std::shared_ptr<pipeline::StageCache>& cache() const { return cache_; }

signals:
  void started(voluta::project::Stage until);
  // In mode auto with the way of building that is being tried.
  void progressed(const voluta::jobs::Progress& progress);
  void stageDone(voluta::project::Stage stage);
  void finished();
  void cancelled();
  void failed(voluta::project::Stage stage, const QString& message);

private:
  void start();
  void startRest();
  void noteEdit();
  void noteSource();
  void noteProgress(const jobs::Progress& progress);
  void end(const base::Outcome<std::shared_ptr<const pipeline::PlanResult>>& outcome);

  Document& document_;
  std::shared_ptr<pipeline::StageCache> cache_;
  jobs::JobRunner runner_;
  std::optional<pipeline::WayInTurn> way_; // that mode auto is trying
  QTimer* startOver_;
  std::optional<project::Stage> waiting_; // for the repair
  project::Stage until_ = project::Stage::Replay;
  bool startsOver_ = false;
};

} // namespace voluta::document
