// The programs of several machines on one clock, with the signals of their marks.
#pragma once

#include "plan/marks.h"
#include "plan/program.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace voluta::replay {

// A mark on a common clock: the machine waits in between. The first one with each other machine is
// the start mark.
struct PassedMark {
  std::size_t other = 0; // the machine that it waits for
  double fromS = 0.0, toS = 0.0;
  std::size_t file = 0, line = 0;
};

// On a common clock: from the moment at which the first program is started.
struct MachineClock {
  std::vector<double> beginS, endS; // per motion
  double totalS = 0.0;
  std::vector<PassedMark> marks; // in their order

  double waitS() const; // at all marks
  // Returns the marks but the start marks.
  std::vector<PassedMark> meetings() const;
};

// A machine that waits for a signal which does not come.
struct Stuck {
  std::size_t machine = 0;
  std::size_t file = 0, line = 0;
};

// How programs are started, and what an earlier run has left.
struct Start {
  std::array<double, plan::kMaxMachines> delayS{};                      // not negative
  std::array<std::bitset<plan::kMarkSignals>, plan::kMaxMachines> on{}; // outputs of marks
};

// Times of all programs; a machine sees a signal of another one (plan/marks.h) kSignalS after it.
inline constexpr double kSignalS = 0.05;
struct CommonClock {
  std::vector<MachineClock> machines;
  std::optional<Stuck> stuck; // the times are then those until then
};
// motionS: duration of each motion of each program [s]. Preconditions: at least two programs, at
// most plan::kMaxMachines; all pointers are valid.
CommonClock commonClock(std::span<const plan::ReadProgram* const> programs,
                        std::span<const std::vector<double>> motionS, const Start& start = {});

// A mark that one machine passes before the other has reached it.
struct EarlyMark {
  std::size_t machine = 0, other = 0;
  std::size_t file = 0, line = 0;
};
// A start after which programs do not keep together (replay/any_start.h): at least one of both.
struct UnsafeStart {
  Start start;
  std::optional<EarlyMark> early;
  std::optional<Stuck> stuck;
};

} // namespace voluta::replay
