// Deterministic pseudo-random bits.
#pragma once

#include <cstdint>

namespace voluta::base {

// The mixing function of SplitMix64 (Steele, Lea & Flood 2014): a bijection.
constexpr std::uint64_t mixedBits(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

} // namespace voluta::base
