// The steps of programs with marks, on a common clock, from any state of the signals.
#pragma once

#include "plan/program.h"
#include "replay/common_clock.h"

#include <cstddef>
#include <span>
#include <vector>

namespace voluta::replay {

// A step of a program that takes time or concerns marks.
struct MarkedAction {
  enum class Kind { Move, Pause, Set, Await };
  Kind kind = Kind::Move;
  double seconds = 0.0;           // Move, Pause
  int signal = 0;                 // Set, Await: over all channels (plan/marks.h)
  bool on = false;                // Set, Await
  std::size_t file = 0, line = 0; // Set, Await
};
// motionS: duration of each motion [s].
std::vector<MarkedAction> markedActions(const plan::ReadProgram& program,
                                        const std::vector<double>& motionS);
// Joins all motions and pauses between two statements of marks to one motion.
std::vector<MarkedAction> joinedMotions(const std::vector<MarkedAction>& actions);

// Precondition: two to plan::kMaxMachines programs.
CommonClock runMarked(std::span<const std::vector<MarkedAction>> programs, const Start& start);

} // namespace voluta::replay
