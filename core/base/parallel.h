// The one place where work is distributed over threads (workers.h implements it).
#pragma once

#include "base/run_context.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace voluta::base {

// Calls body(begin, end) for consecutive chunks of [0, count), each `grain` long but the last, on
// up to ctx.threads() threads. The chunks do not depend on the number of threads, so neither do
// results written per index or per chunk. Checks for cancellation between chunks and throws
// Cancelled. Rethrows the first exception (by chunk order).
void parallelChunks(const RunContext& ctx, std::size_t count, std::size_t grain,
                    const std::function<void(std::size_t begin, std::size_t end)>& body);

// Calls body(index) for each of [0, count) in the same way, one by one, and reports progress to
// ctx, up to `share` of its work, in the phase `phase`. The calling thread reports and also takes
// part in the work.
void parallelWithProgress(const RunContext& ctx, std::size_t count, double share, const Text& phase,
                          const std::function<void(std::size_t index)>& body);

// Returns the sum of body(begin, end) over the chunks, added in chunk order: the same for any
// number of threads.
template <typename T>
T parallelSum(const RunContext& ctx, std::size_t count, std::size_t grain, T zero,
              const std::function<T(std::size_t begin, std::size_t end)>& body) {
  std::vector<T> partial(grain == 0 ? 0 : (count + grain - 1) / grain, zero);
  parallelChunks(ctx, count, grain,
                 [&](std::size_t b, std::size_t e) { partial[b / grain] = body(b, e); });
  T total = zero;
  for (const T& p : partial)
    total += p;
  return total;
}

} // namespace voluta::base
