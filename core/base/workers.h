// Threads that are kept waiting between tasks, so that small pieces of work are worth distributing.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace voluta::base {

// The threads of a run; use them through parallel.h.
class Workers {
public:
  // threads >= 1, including the caller.
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  // Calls work(i) for every i in [0, count) and returns when all calls are done. `work` must not
  // throw. May be called from several threads, and from within `work`, which then waits only for
  // its own calls.
  void onEach(std::size_t count, const std::function<void(std::size_t)>& work);

private:
  struct Pool;
  std::unique_ptr<Pool> pool_;
};

} // namespace voluta::base
