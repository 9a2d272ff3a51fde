#include "base/memory.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <malloc.h>
#include <string>
#include <sys/resource.h>

namespace voluta::base {

namespace {
constexpr std::uint64_t kUnknown = std::numeric_limits<std::uint64_t>::max();

std::string textOf(const char* file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// "max" and a missing file count as unknown.
std::uint64_t numberIn(const char* file) {
  const std::string text = textOf(file);
  std::uint64_t value = 0;
  return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc{}
             ? value
             : kUnknown;
}
} // namespace

std::uint64_t kibibytesOf(std::string_view text, std::string_view key) {
  const std::size_t at = text.find(key);
  if (at == std::string_view::npos)
    return 0;
  const std::size_t digits = text.find_first_of("0123456789", at + key.size());
  const std::size_t end = text.find('\n', at);
  if (digits == std::string_view::npos || digits > end)
    return 0;
  std::uint64_t value = 0;
  std::from_chars(text.data() + digits, text.data() + text.size(), value);
  return 1024 * value;
}

std::uint64_t availableMemory() {
  const std::uint64_t free = kibibytesOf(textOf("/proc/meminfo"), "MemAvailable:");
  const std::uint64_t limit = numberIn("/sys/fs/cgroup/memory.max");
  const std::uint64_t used = numberIn("/sys/fs/cgroup/memory.current");
  const std::uint64_t remaining =
      limit == kUnknown || used == kUnknown ? kUnknown : limit - std::min(limit, used);
  return std::min(free == 0 ? kUnknown : free, remaining);
}

void returnFreedMemory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

double peakResidentMb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0; // Linux reports KiB
}

} // namespace voluta::base
