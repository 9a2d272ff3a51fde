#include "base/parallel.h"

#include "base/error.h"

#include <algorithm>
#include <exception>

#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <thread>
#else
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace voluta::base {

namespace {

// Calls work(c) for every c in [0, count) on up to `threads` threads. `work` throws nothing.
#ifdef __SANITIZE_THREAD__
// TBB is not built with the thread sanitizer, which therefore sees neither how it hands work over
// nor how it waits: threads of our own, taken in turn by a count that orders nothing else.
template <typename Work> void onThreads(int threads, std::size_t count, const Work& work) {
  std::atomic<std::size_t> next = 0;
  const auto take = [&] {
    for (std::size_t c; (c = next.fetch_add(1, std::memory_order_relaxed)) < count;)
      work(c);
  };
  std::vector<std::jthread> others;
  for (int t = 1; t < threads; ++t)
    others.emplace_back(take);
  take();
}
#else
template <typename Work> void onThreads(int threads, std::size_t count, const Work& work) {
  oneapi::tbb::task_arena arena(threads);
  arena.execute([&] {
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
          for (std::size_t c = range.begin(); c != range.end(); ++c)
            work(c);
        },
        oneapi::tbb::simple_partitioner());
  });
}
#endif

} // namespace

void parallelChunks(const RunContext& ctx, std::size_t count, std::size_t grain,
                    const std::function<void(std::size_t, std::size_t)>& body) {
  require(grain > 0, "parallelChunks: grain > 0");
  const std::size_t chunks = (count + grain - 1) / grain;
  const auto runChunk = [&](std::size_t c) { body(c * grain, std::min(count, (c + 1) * grain)); };
  ctx.checkpoint();
  if (ctx.threads() == 1 || chunks <= 1) {
    for (std::size_t c = 0; c < chunks; ++c) {
      ctx.checkpoint();
      runChunk(c);
    }
    return;
  }
  std::vector<std::exception_ptr> failed(chunks);
  onThreads(ctx.threads(), chunks, [&](std::size_t c) {
    if (ctx.cancelled())
      return;
    try {
      runChunk(c);
    } catch (...) {
      failed[c] = std::current_exception();
    }
  });
  ctx.checkpoint();
  for (const std::exception_ptr& e : failed)
    if (e)
      std::rethrow_exception(e);
}

} // namespace voluta::base
