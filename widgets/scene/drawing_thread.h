// A thread for drawing off screen. A thread that has drawn holds data of libEGL and Mesa, which are
// freed when it ends. If it ends while the process does, as the threads of a pool do, this has
// destroyed the heap. So pictures are drawn in threads of their own, which have ended before the
// caller goes on.
#pragma once

#include <future>
#include <thread>
#include <type_traits>
#include <utility>

namespace voluta::scene {

// Calls work() in a new thread and waits until that thread has ended. Returns the result of the
// call or throws its exception. `work` must create, use and destroy its OffscreenTarget and Scene.
template <typename F> std::invoke_result_t<F> inDrawingThread(F work) {
  std::packaged_task<std::invoke_result_t<F>()> task(std::move(work));
  auto result = task.get_future();
  std::thread(std::move(task)).join();
  return result.get();
}

} // namespace voluta::scene
