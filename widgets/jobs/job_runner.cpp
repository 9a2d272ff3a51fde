#include "jobs/job_runner.h"

#include "base/error.h"
#include "jobs/background_thread.h"
#include "jobs/time_left.h"

#include <QElapsedTimer>
#include <QMetaObject>
#include <QPointer>
#include <QTimer>
#include <algorithm>
#include <thread>

namespace voluta::jobs {

namespace {
constexpr int kTickMs = 55; // Coarse timers may fire up to 5 % early
}

int defaultThreads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Shared by the runner and the thread; the last one to end frees it.
struct JobRunner::Run {
  base::CancelToken cancel;
  QElapsedTimer elapsed; // Used by the window's thread only, like timeLeft
  TimeLeft timeLeft;

  std::mutex mutex;            // Guards the members below
  JobRunner* runner = nullptr; // Null after the run was abandoned
  double fraction = 0.0;
  base::Message stage;

  void report(double done, const base::Message& what) {
    const std::lock_guard lock(mutex);
    fraction = done;
    stage = what;
  }

  // Calls f() on the runner's thread unless `self` was abandoned by then.
  static void post(const std::shared_ptr<Run>& self, std::function<void()> f) {
    const std::lock_guard lock(self->mutex);
    if (!self->runner)
      return;
    QMetaObject::invokeMethod(
        self->runner,
        [self, f = std::move(f)] {
          // No lock is needed: the runner is only reset on this thread.
          if (self->runner)
            f();
        },
        Qt::QueuedConnection);
  }
};

JobRunner::JobRunner(QObject* parent) : QObject(parent), timer_(new QTimer(this)) {
  timer_->setInterval(kTickMs);
  connect(timer_, &QTimer::timeout, this, &JobRunner::tick);
}

JobRunner::~JobRunner() {
  abandon();
}

void JobRunner::start(ErasedWork work, ErasedDone done, int threads) {
  base::require(threads >= 1, "JobRunner: threads >= 1");
  abandon();
  auto run = std::make_shared<Run>();
  run->runner = this;
  run->elapsed.start();
  const base::RunContext ctx(
      run->cancel, threads,
      [run = run.get()](double f, const base::Message& w) { run->report(f, w); });
  startInBackground([run, ctx, work = std::move(work)]() mutable {
    const Post post = [run](std::function<void()> f) { Run::post(run, std::move(f)); };
    std::shared_ptr<void> outcome = work(ctx, post);
    work = nullptr;
    Run::post(run, [run, outcome] { run->runner->finish(outcome); });
  });
  run_ = std::move(run);
  done_ = std::move(done);
  progress_ = {};
  timer_->start();
  emit started();
}

void JobRunner::abandon() {
  if (!run_)
    return;
  run_->cancel.cancel();
  {
    const std::lock_guard lock(run_->mutex);
    run_->runner = nullptr;
  }
  run_.reset();
  done_ = nullptr;
  timer_->stop();
}

void JobRunner::cancel() {
  if (!run_)
    return;
  const ErasedDone done = std::move(done_);
  const std::shared_ptr<Run> run = run_;
  abandon();
  const QPointer<JobRunner> alive(this);
  done(nullptr);
  if (alive && !run_)
    emit finished();
}

void JobRunner::finish(const std::shared_ptr<void>& outcome) {
  const ErasedDone done = std::move(done_);
  abandon();
  const QPointer<JobRunner> alive(this);
  done(outcome);
  if (alive && !run_)
    emit finished();
}

void JobRunner::tick() {
  Progress now;
  {
    const std::lock_guard lock(run_->mutex);
    now.stage = run_->stage;
    now.fraction = run_->fraction;
  }
  now.secondsLeft = run_->timeLeft.update(run_->elapsed.elapsed() / 1000.0, now.fraction);
  if (now.stage == progress_.stage && now.fraction == progress_.fraction &&
      now.secondsLeft == progress_.secondsLeft)
    return;
  progress_ = now;
  emit progressed(progress_);
}

} // namespace voluta::jobs
