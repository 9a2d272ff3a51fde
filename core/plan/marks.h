// Signals of marks, at which two machines wait for each other.
//
// Each machine has two outputs that are inputs of the other. Mark n (counted from 1) is announced
// on output (n - 1) mod 2, which is switched on and off in turn; then the machine waits until the
// input with the same number has the same value. A single pair would not do: a machine that passes
// a mark and reaches the next one at once would take its signal away before the other has seen it.
// With two, the signal of a mark stays until both have passed the next one.
#pragma once

#include <cstddef>

namespace voluta::plan {

// Place of a mark in the cycle of signals.
inline constexpr std::size_t kMarkCycle = 4;
constexpr int markPlace(std::size_t number) {
  return static_cast<int>((number - 1) % kMarkCycle);
}
constexpr int markSignal(int place) {
  return place % 2;
}
constexpr bool markIsOn(int place) {
  return place < 2;
}
constexpr int markPlaceOf(int signal, bool on) {
  return signal + (on ? 0 : 2);
}

} // namespace voluta::plan
