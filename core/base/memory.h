// How much memory the machine can still give, and what was taken of it.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace voluta::base {

// Bytes that can be taken without swapping: what the kernel calls available, or what the control
// group of this process leaves, if that is less. The largest number where neither is known.
std::uint64_t availableMemory();

// The most that this process has held at once, in MiB.
double peakResidentMb();

// Gives back to the system what was freed and is kept for the next time: stages and their steps
// hold much while they last, and another one's blocks don't fit into theirs.
void returnFreedMemory();

// Empties them and gives back what they hold, which `= {}` does not.
template <typename... Ts> void freeStorage(std::vector<Ts>&... vectors) {
  (std::vector<Ts>().swap(vectors), ...);
}

// The number after `key` in text like that of /proc/meminfo, times 1024; 0: not there.
std::uint64_t kibibytesOf(std::string_view text, std::string_view key);

} // namespace voluta::base
