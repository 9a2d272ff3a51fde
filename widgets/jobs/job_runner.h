// Runs core functions on a background thread; progress and results arrive on the window's thread.
#pragma once

#include "base/outcome.h"
#include "base/run_context.h"

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>

class QTimer;

namespace voluta::jobs {

struct Progress {
  base::Message stage;               // Current activity
  double fraction = 0.0;             // Of the whole run, [0, 1]
  std::optional<double> secondsLeft; // Smoothed; nullopt in the first 2 s
};

// Passes a function to the window's thread, which calls it in order as long as its run is the
// current one; dropped once the run was cancelled or replaced or its runner destroyed. Copies are
// cheap and may outlive the run.
using Post = std::function<void(std::function<void()>)>;

// Returns the default number of threads of a run: all of the machine's.
int defaultThreads();

// Runs one job at a time. All functions and signals belong to the runner's thread.
class JobRunner : public QObject {
  Q_OBJECT

public:
  explicit JobRunner(QObject* parent = nullptr);
  // Cancels; returns at once.
  ~JobRunner() override;

  // Calls work(ctx) or work(ctx, post) on a separate thread and then done(outcome) on this one. A
  // previous run is cancelled first and its `done` is never called: of several runs in a row only
  // the newest delivers. `work` must not access objects of the window; it is destroyed on its own
  // thread, `done` on this one. Precondition: threads >= 1.
  template <typename Work, typename Done>
  void run(Work work, Done done, int threads = defaultThreads());

  // Ends the run for the window at once: done(Cancelled) is called before this returns. The thread
  // ends at its next checkpoint, unnoticed, and its result is dropped. Does nothing without a run.
  void cancel();

  bool running() const { return static_cast<bool>(run_); }
  // Of the current run, or of the last one after its end.
  const Progress& progress() const { return progress_; }

signals:
  void started();
  void progressed(const voluta::jobs::Progress& progress); // At most 20 per second
  void finished();                                         // After done() of the newest run

private:
  struct Run;
  using ErasedWork = std::function<std::shared_ptr<void>(const base::RunContext&, const Post&)>;
  // nullptr: cancelled.
  using ErasedDone = std::function<void(std::shared_ptr<void>)>;

  void start(ErasedWork work, ErasedDone done, int threads);
  void abandon();
  void finish(const std::shared_ptr<void>& outcome);
  void tick();

  std::shared_ptr<Run> run_;
  ErasedDone done_;
  Progress progress_;
  QTimer* timer_;
};

template <typename Work, typename Done> void JobRunner::run(Work work, Done done, int threads) {
  auto call = [work = std::move(work)](const base::RunContext& ctx, const Post& post) mutable {
    if constexpr (std::is_invocable_v<Work&, const base::RunContext&, const Post&>)
      return work(ctx, post);
    else
      return work(ctx);
  };
  using T = std::invoke_result_t<decltype(call)&, const base::RunContext&, const Post&>;
  auto shared = std::make_shared<decltype(call)>(std::move(call));
  start(
      [shared](const base::RunContext& ctx, const Post& post) -> std::shared_ptr<void> {
        return std::make_shared<base::Outcome<T>>(
            base::outcomeOf([&]() -> T { return (*shared)(ctx, post); }));
      },
      [done = std::move(done)](const std::shared_ptr<void>& outcome) mutable {
        if (outcome)
          done(std::move(*std::static_pointer_cast<base::Outcome<T>>(outcome)));
        else
          done(base::Outcome<T>(base::Cancelled{}));
      },
      threads);
}

} // namespace voluta::jobs
