#include "cli/run_interruptibly.h"

#include <csignal>
#include <ctime>
#include <pthread.h>

namespace voluta::cli {

namespace {
sigset_t interruptSet() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}
} // namespace

void blockInterrupts() {
  const sigset_t set = interruptSet();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

bool waitOrInterrupted(const std::function<bool()>& done) {
  const sigset_t set = interruptSet();
  constexpr timespec kPause{0, 10'000'000}, kNone{0, 0};
  if (sigtimedwait(&set, nullptr, &kNone) > 0)
    return true;
  while (!done())
    if (sigtimedwait(&set, nullptr, &kPause) > 0)
      return true;
  return false;
}

} // namespace voluta::cli
