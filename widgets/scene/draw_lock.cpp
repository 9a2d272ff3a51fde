#include "scene/draw_lock.h"

namespace voluta::scene {

std::unique_lock<std::mutex> drawLock() {
  static std::mutex mutex;
  return std::unique_lock(mutex);
}

} // namespace voluta::scene
