// Marks, at which two machines wait for each other, and their signals.
//
// For each of the others a machine has a channel: two outputs that are inputs of the other machine,
// and two inputs that are outputs of it. The machine with the lower number leads. All signals are
// off between marks, but the second one of the machine that follows, which is on from its start
// mark to its end. The first mark of a channel, at the first point of both motions, is the start
// mark; it is right whatever state an earlier run has left, in whatever order and however much
// later the programs are started:
//
//   leads:   2 off, awaits 2 off, 2 on, 1 on, awaits 2 on, 2 off, awaits 1 on, 1 off, awaits 1 off
//   follows: 2 off, awaits 2 on, 2 on, awaits 2 off, 2 off, awaits 1 on, 2 on, 1 on, awaits 1 off,
//            1 off
//
// Each sees the other's second signal change, which a machine that is not running cannot show it.
// Signal 1 is off before that, since both withdraw it where their programs begin, before the motion
// to the first point. At every further mark:
//
//   leads:   1 on, awaits 1 on, 1 off, awaits 1 off
//   follows: awaits 1 on, 1 on, awaits 1 off, 1 off
//
// Every signal stays until the other machine has answered it, so it does not matter how much later
// a change is seen, nor which of two signals is seen first. At the end both are withdrawn. A
// machine that is restarted alone goes to its first point and waits there, since the other one's
// second signal does not change amid its work, and the other one does not pass its next mark.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace voluta::plan {

struct Trajectory;

// Machines in one cell; the others of each have the channels 0, 1 .. in their order.
inline constexpr std::size_t kMaxMachines = 4;
inline constexpr int kMarkChannels = static_cast<int>(kMaxMachines) - 1;
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

// One end of a channel, as the events of a trajectory state it.
inline constexpr int kMarkLinks = 2 * kMarkChannels;
constexpr int markLink(int channel, bool leads) {
  return channel + (leads ? 0 : kMarkChannels);
}
constexpr int markLinkOf(std::size_t machine, std::size_t other) {
  return markLink(markChannel(machine, other), machine < other);
}
constexpr int markChannelOf(int link) {
  return link % kMarkChannels;
}
constexpr bool markLeads(int link) {
  return link < kMarkChannels;
}

// A signal (0 or 1 of a channel; outputs and inputs are counted from 0 over all channels) and its
// value in one number, as programs state it (plan/stated_facts.h).
constexpr int markCode(int signal, bool on) {
  return 2 * signal + (on ? 1 : 0);
}
constexpr int markSignalOf(int code) {
  return code / 2;
}
constexpr bool markIsOn(int code) {
  return code % 2 != 0;
}

// Sets an output of a channel, or waits until its input has that value.
struct MarkStep {
  bool sets = true;
  int signal = 0; // 0 or 1
  bool on = false;
};
// Returns the steps of a mark; `isFirst`: of the start mark.
std::span<const MarkStep> markSteps(bool leads, bool isFirst);

// Returns the links that have marks in the trajectory; ascending by channel.
std::vector<int> markLinksOf(const Trajectory& trajectory);
// Returns the signals of their channels; ascending.
std::vector<int> markSignalsOf(const Trajectory& trajectory);

// What a program states about its marks. Those of a point come after the arrival at the point
// before, and before all else there; those of point 0 before the first motion.
inline constexpr std::size_t kNoEvent = std::numeric_limits<std::size_t>::max();
struct MarkStatement {
  std::size_t point = 0;        // 0 .. pointCount()
  std::size_t event = kNoEvent; // of the trajectory; kNoEvent: withdraws a signal
  bool sets = true;
  int signal = 0; // over all channels
  bool on = false;
};
// Returns them in their order; empty without marks. Precondition: marks have links below
// kMarkLinks.
std::vector<MarkStatement> markStatements(const Trajectory& trajectory);

} // namespace voluta::plan
