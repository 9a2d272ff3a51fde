#include "base/parallel.h"

#include "base/error.h"
#include "base/workers.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

namespace voluta::base {

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
  ctx.workers().onEach(chunks, [&](std::size_t c) {
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

void parallelWithProgress(const RunContext& ctx, std::size_t count, double share, const Text& phase,
                          const std::function<void(std::size_t)>& body) {
  const std::thread::id teller = std::this_thread::get_id();
  std::atomic<std::size_t> finished = 0;
  ctx.report(0.0, phase);
  parallelChunks(ctx, count, 1, [&](std::size_t index, std::size_t) {
    body(index);
    const auto done = static_cast<double>(++finished);
    if (std::this_thread::get_id() == teller)
      ctx.report(share * done / static_cast<double>(count), phase);
  });
}

} // namespace voluta::base
