#include "base/workers.h"

#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <thread>
#include <vector>
#else
#include <algorithm>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace voluta::base {

#ifdef __SANITIZE_THREAD__
// TBB is not built with the thread sanitizer, which therefore does not see its hand-over and waits.
// Under the sanitizer, plain threads take the work in turn from a counter that imposes no other
// order.
struct Workers::Pool {
  int threads;

  void onEach(std::size_t count, const std::function<void(std::size_t)>& work) const {
    std::atomic<std::size_t> next = 0;
    const auto take = [&] {
      for (std::size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;)
        work(i);
    };
    std::vector<std::jthread> others;
    for (int t = 1; t < threads; ++t)
      others.emplace_back(take);
    take();
  }
};
#else
struct Workers::Pool {
  // TBB has at most as many threads as the machine has cores, and warns about each larger arena.
  explicit Pool(int threads) : arena(std::min(threads, oneapi::tbb::info::default_concurrency())) {}
  oneapi::tbb::task_arena arena;

  void onEach(std::size_t count, const std::function<void(std::size_t)>& work) {
    arena.execute([&] {
      // A thread waiting here must not begin other work, which may hold resources that the awaited
      // work needs.
      oneapi::tbb::this_task_arena::isolate([&] {
        oneapi::tbb::parallel_for(
            oneapi::tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
              for (std::size_t i = range.begin(); i != range.end(); ++i)
                work(i);
            },
            oneapi::tbb::simple_partitioner());
      });
    });
  }
};
#endif

Workers::Workers(int threads) : pool_(new Pool{threads}) {}
Workers::~Workers() = default;

void Workers::onEach(std::size_t count, const std::function<void(std::size_t)>& work) {
  pool_->onEach(count, work);
}

} // namespace voluta::base
