#include "base/parallel.h"

#include "base/error.h"

#include <algorithm>
#include <exception>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace voluta::base {

namespace {

// TBB hands work over unseen by the thread sanitizer, which it is not built with: this tells it
// that chunks begin after the call and end before its return. Not that one chunk comes after
// another, so that what two of them do to the same data is seen.
class ForkAndJoin {
public:
#ifdef __SANITIZE_THREAD__
  ForkAndJoin() {
    __tsan_release(&fork_);
  }
  void begin() {
    __tsan_acquire(&fork_);
  }
  void end() {
    __tsan_release(&join_);
  }
  void join() {
    __tsan_acquire(&join_);
  }

private:
  char fork_ = 0, join_ = 0;
#else
  void begin() {}
  void end() {}
  void join() {}
#endif
};

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
  ForkAndJoin order;
  oneapi::tbb::task_arena arena(ctx.threads());
  arena.execute([&] {
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<std::size_t>(0, chunks, 1),
        [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
          order.begin();
          for (std::size_t c = range.begin(); c != range.end(); ++c) {
            if (ctx.cancelled())
              break;
            try {
              runChunk(c);
            } catch (...) {
              failed[c] = std::current_exception();
            }
          }
          order.end();
        },
        oneapi::tbb::simple_partitioner());
  });
  order.join();
  ctx.checkpoint();
  for (const std::exception_ptr& e : failed)
    if (e)
      std::rethrow_exception(e);
}

} // namespace voluta::base
