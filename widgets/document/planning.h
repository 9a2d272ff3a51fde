// Plans a document in the background and delivers the results stage by stage.
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

// Returns the progress to show while mode auto tries `strategy`, including its name. The remaining
// time is included for the last way only, since an earlier one may be the last that is planned, or
// end at once.
jobs::Progress progressOfStrategy(jobs::Progress progress,
                                  const pipeline::StrategyProgress& strategy);

// Results stay visible, marked out of date, until newer ones replace them; after a cancel or an
// error the last ones stay. Only changed stages are recomputed.
class Planning : public QObject {
  Q_OBJECT

public:
  // `document` has to outlive the object.
  explicit Planning(Document& document, QObject* parent = nullptr);
  ~Planning() override;

  // Starts, or restarts. Waits while the part is still being repaired. Does nothing without a part.
  void plan(project::Stage until = project::Stage::Replay);
  // The window is responsive when this returns.
  void cancel();
  bool running() const;
  // On: a change of the document during a run restarts it (0.3 s after the last change). Off
  // (initially): the run continues and its results arrive out of date.
  void setStartsOver(bool on) { startsOver_ = on; }

  // Last stage of the present or last run.
  project::Stage until() const { return until_; }
  // Cached results, to be seeded from an opened project; thread-safe.
  const std::shared_ptr<pipeline::StageCache>& cache() const { return cache_; }
  // Cancels, drops the results of the document that is closed, and returns its memory to the
  // system. `cache`: of the next document; null: an empty one.
  void startAfresh(std::shared_ptr<pipeline::StageCache> cache = nullptr);

signals:
  void started(voluta::project::Stage until);
  // In mode auto including the way of building being tried.
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
  jobs::JobRunner memory_; // returns freed memory
  std::optional<pipeline::StrategyProgress> strategy_; // that mode auto is trying
  QTimer* startOver_;
  QTimer* returnMemory_;
  std::optional<project::Stage> waiting_; // for the repair
  project::Stage until_ = project::Stage::Replay;
  bool startsOver_ = false;
};

} // namespace voluta::document
