// Damaged copies of whole files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace voluta::fuzz {

// One of the seeds with a few changes: bytes and numbers put in, taken out, moved, repeated, taken
// from another seed. The same for the same number. Precondition: seeds is not empty.
std::string mutated(const std::vector<std::string>& seeds, std::uint64_t number);

} // namespace voluta::fuzz
