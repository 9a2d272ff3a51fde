#include "base/run_context.h"

#include "base/error.h"
#include "base/workers.h"

#include <algorithm>
#include <utility>

namespace voluta::base {

RunContext::RunContext(CancelToken cancel, int threads, ProgressSink sink)
    : cancel_(std::move(cancel)), threads_(threads), sink_(std::move(sink)) {
  require(threads >= 1, "RunContext: threads >= 1");
  if (threads > 1)
    workers_ = std::make_shared<Workers>(threads);
}

void RunContext::checkpoint() const {
  if (cancelled())
    throw Cancelled{};
}

void RunContext::report(double fraction, const Message& what) const {
  checkpoint();
  if (sink_)
    sink_(lo_ + (hi_ - lo_) * std::clamp(fraction, 0.0, 1.0), what);
}

RunContext RunContext::sub(double lo, double hi) const {
  RunContext inner = *this;
  inner.lo_ = lo_ + (hi_ - lo_) * lo;
  inner.hi_ = lo_ + (hi_ - lo_) * hi;
  return inner;
}

RunContext RunContext::quiet() const {
  RunContext silent = *this;
  silent.sink_ = {};
  return silent;
}

} // namespace voluta::base
