// Available memory of the machine and memory use of this process.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace voluta::base {

// Returns the bytes that can be allocated without swapping: the kernel's estimate of available
// memory, or the rest of this process's control group limit if that is less. Returns the largest
// number if neither is known.
std::uint64_t availableMemory();

// Returns the peak resident memory of this process [MiB].
double peakResidentMb();

// Returns freed heap pages to the operating system (malloc_trim). Stages hold much memory while
// they run, and the freed blocks of one often do not fit the needs of the next.
void returnFreedMemory();

// Empties the vectors and frees their storage, which `= {}` does not.
template <typename... Ts> void freeStorage(std::vector<Ts>&... vectors) {
  (std::vector<Ts>().swap(vectors), ...);
}

// Returns the number after `key` in text like that of /proc/meminfo, times 1024; 0 if it is
// missing.
std::uint64_t kibibytesOf(std::string_view text, std::string_view key);

} // namespace voluta::base
