// Threads that wait for work in between, so that small pieces of it are worth handing over.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace voluta::base {

// The threads of a run; parallel.h is how to use them.
class Workers {
public:
  // threads >= 1, the caller's among them.
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  // Calls work(i) for every i in [0, count) and returns when all is done. `work` throws nothing.
  // May be called from several threads, and from within `work`, which then waits for nothing else.
  void onEach(std::size_t count, const std::function<void(std::size_t)>& work);

private:
  struct Pool;
  std::unique_ptr<Pool> pool_;
};

} // namespace voluta::base
