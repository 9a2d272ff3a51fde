// Limits of the programs that read files of others with foreign libraries: a damaged file must not
// take the computer with it.
#pragma once

#include <csignal>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace voluta {

// Limits this process to 4 GB of memory and to the given time of the processor, without a core
// file. It ends with the program that started it.
inline void limitReader(rlim_t seconds) {
  constexpr rlim_t kMaxMemory = rlim_t(4) << 30;
  const auto limit = [](auto what, rlim_t maximum) {
    const rlimit limits{maximum, maximum};
    setrlimit(what, &limits);
  };
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  limit(RLIMIT_AS, kMaxMemory); // A sanitizer maps terabytes of addresses
#endif
  limit(RLIMIT_CPU, seconds);
  limit(RLIMIT_CORE, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL); // Nobody reads the result of a cancelled program
}

} // namespace voluta
