// Signals of marks, at which two machines wait for each other.
//
// For each of the others a machine has a channel: two outputs that are inputs of the other machine,
// and two inputs that are outputs of it. Mark n of a channel (counted from 1) is announced on its
// output (n - 1) mod 2, which is switched on and off in turn; then the machine waits until the
// input with the same number has the same value. A single pair would not do: a machine that passes
// a mark and reaches the next one at once would take its signal away before the other has seen it.
// With two, the signal of a mark stays until both have passed the next one.
#pragma once

#include <cstddef>
#include <vector>

namespace voluta::plan {

struct Trajectory;

// Machines in one cell; the others of each have the channels 0, 1 .. in their order.
inline constexpr std::size_t kMostMachines = 4;
inline constexpr int kMarkChannels = static_cast<int>(kMostMachines) - 1;
inline constexpr int kMarkSignals = 2 * kMarkChannels;
// Precondition: other != machine.
constexpr int markChannel(std::size_t machine, std::size_t other) {
  return static_cast<int>(other < machine ? other : other - 1);
}
// The inverse: the machine at the other end of a channel.
constexpr std::size_t markPeer(std::size_t machine, int channel) {
  const auto other = static_cast<std::size_t>(channel);
  return other < machine ? other : other + 1;
}

// Place of a mark in the cycles of signals: kMarkCycle places for each channel.
inline constexpr std::size_t kMarkCycle = 4;
constexpr int markPlace(int channel, std::size_t number) {
  return channel * static_cast<int>(kMarkCycle) + static_cast<int>((number - 1) % kMarkCycle);
}
constexpr int markChannelOf(int place) {
  return place / static_cast<int>(kMarkCycle);
}
// Returns the number of the output or input, counted from 0 over all channels.
constexpr int markSignal(int place) {
  return 2 * markChannelOf(place) + place % 2;
}
constexpr bool markIsOn(int place) {
  return place % static_cast<int>(kMarkCycle) < 2;
}
constexpr int markPlaceOf(int signal, bool on) {
  return signal / 2 * static_cast<int>(kMarkCycle) + signal % 2 + (on ? 0 : 2);
}

// Returns the signals of all channels that have marks in the trajectory; ascending.
std::vector<int> markSignalsOf(const Trajectory& trajectory);

} // namespace voluta::plan
