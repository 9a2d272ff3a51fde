// Vectors of four numbers (GCC's and Clang's vector types: operators, comparisons and ?: work per
// lane).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace voluta::base {

inline constexpr int kLanes = 4;
using Floats = float __attribute__((vector_size(kLanes * sizeof(float))));
using Ints = std::int32_t __attribute__((vector_size(kLanes * sizeof(std::int32_t))));

// Loads four consecutive numbers, which need not be aligned.
template <typename Four, typename T> Four load(const T* first) {
  Four four;
  std::memcpy(&four, first, sizeof(four));
  return four;
}
template <typename Four, typename T> void store(const Four& four, T* first) {
  std::memcpy(first, &four, sizeof(four));
}

inline Floats floatsOf(Ints v) {
  return __builtin_convertvector(v, Floats);
}
// Rounds towards zero.
inline Ints intsOf(Floats v) {
  return __builtin_convertvector(v, Ints);
}
inline Floats min(Floats a, Floats b) {
  return a < b ? a : b;
}
inline Floats max(Floats a, Floats b) {
  return a < b ? b : a;
}
inline Floats absOf(Floats v) {
  return v < 0.0f ? -v : v;
}
// Precondition: v >= 0.
inline Floats fractionOf(Floats v) {
  return v - floatsOf(intsOf(v));
}

} // namespace voluta::base
