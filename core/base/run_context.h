// The environment of a running stage (docs/design.md, Progress and cancel): progress,
// cancellation, threads.
#pragma once

#include "base/text.h"

#include <atomic>
#include <functional>
#include <memory>

namespace voluta::base {

class Workers;

// A flag that stays set; created for each run and shared with all that may cancel it.
class CancelToken {
public:
  CancelToken() : flag_(std::make_shared<std::atomic<bool>>(false)) {}
  void cancel() const noexcept { flag_->store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept { return flag_->load(std::memory_order_relaxed); }

private:
  std::shared_ptr<std::atomic<bool>> flag_;
};

// Progress of the whole run: fraction in [0,1] and the current activity in a few words. Called from
// the thread that runs the stage, never from workers.
using ProgressSink = std::function<void(double fraction, const Message& what)>;

// A small value, passed to every stage as const&. Copies share the cancel token, the threads and
// the sink.
class RunContext {
public:
  // Silent, never cancelled, one thread: for tests and small calls.
  RunContext() = default;
  // threads >= 1.
  RunContext(CancelToken cancel, int threads, ProgressSink sink = {});

  int threads() const { return threads_; }
  // Precondition: threads() > 1.
  Workers& workers() const { return *workers_; }

  // For inner loops: cheap; to be checked at least every 50 ms.
  bool cancelled() const noexcept { return cancel_.cancelled(); }
  // Throws Cancelled once the run was cancelled.
  void checkpoint() const;

  // Reports `fraction` in [0,1] of this context's span, and calls checkpoint().
  void report(double fraction, const Message& what) const;

  // Returns a context for a part of the work that covers [lo, hi] of this one's span.
  RunContext sub(double lo, double hi) const;
  // Returns the same run without progress: for work on several threads, and for small steps of a
  // stage that reports as a whole.
  RunContext quiet() const;

private:
  CancelToken cancel_;
  int threads_ = 1;
  std::shared_ptr<Workers> workers_; // Null: one thread
  double lo_ = 0.0, hi_ = 1.0;
  ProgressSink sink_;
};

} // namespace voluta::base
