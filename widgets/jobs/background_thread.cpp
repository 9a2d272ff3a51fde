#include "jobs/background_thread.h"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace voluta::jobs {

namespace {
constexpr int kNiceness = 10;
constexpr std::chrono::milliseconds kPatience{300};

// The running threads of this process. Never destroyed, because threads may outlive everything
// else.
struct Running {
  std::mutex mutex;
  std::condition_variable none;
  std::size_t count = 0;
};

void leaveRunningThreads(int status, void* running) {
  auto& r = *static_cast<Running*>(running);
  std::unique_lock lock(r.mutex);
  if (r.none.wait_for(lock, kPatience, [&] { return r.count == 0; }))
    return;
  std::fflush(nullptr);
  ::_exit(status);
}

Running& runningThreads() {
  static Running* running = [] {
    auto made = std::make_unique<Running>();
    ::on_exit(leaveRunningThreads, made.get());
    return made.release();
  }();
  return *running;
}
} // namespace

void startInBackground(std::function<void()> work) {
  Running& running = runningThreads();
  {
    const std::lock_guard lock(running.mutex);
    ++running.count;
  }
  const auto ended = [&running] {
    const std::lock_guard lock(running.mutex);
    if (--running.count == 0)
      running.none.notify_all();
  };
  try {
    std::thread([work = std::move(work), ended]() mutable {
      ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNiceness);
      work();
      work = nullptr;
      ended();
    }).detach();
  } catch (...) {
    ended();
    throw;
  }
}

} // namespace voluta::jobs
