// Runs the programs of several machines in one time, with the signals of their marks, and looks for
// collisions between them.
#pragma once

#include "base/text.h"
#include "plan/marks.h"
#include "plan/program.h"
#include "process/process.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// A program, as read back, and its cell in the frame that all machines share.
struct RunningMachine {
  const plan::ReadProgram& program;
  const robot::Cell& cell;
  const process::Process& process; // of the tool that the program begins with
  Eigen::Isometry3d shared_T_world = Eigen::Isometry3d::Identity();
};

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
  std::array<double, plan::kMostMachines> delayS{};                      // not negative
  std::array<std::bitset<plan::kMarkSignals>, plan::kMostMachines> on{}; // outputs of marks
};

// Times of all programs; a machine sees a signal of another one (plan/marks.h) kSignalS after it.
inline constexpr double kSignalS = 0.05;
struct CommonClock {
  std::vector<MachineClock> machines;
  std::optional<Stuck> stuck; // the times are then those until then
};
// motionS: duration of each motion of each program [s]. Preconditions: at least two programs, at
// most plan::kMostMachines; all pointers are valid.
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

// A contact of two machines; consecutive samples with the same bodies are one.
struct Meeting {
  double whenS = 0.0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero(); // shared frame [mm]
  std::array<std::size_t, 2> machines{};           // ascending
  std::array<base::Value, 2> bodies;               // their names
};

// Distances are computed up to this [mm].
inline constexpr double kMachinesCapMm = 300.0;
struct SharedRun {
  CommonClock clock; // after unsafeStart, if there is one; else from signals that are off
  std::optional<UnsafeStart> unsafeStart;
  double makespanS = 0.0;
  std::size_t collisions = 0;
  std::vector<Meeting> meetings; // the first ones
  // Of moving bodies of one machine to those of another.
  double leastDistanceMm = kMachinesCapMm, leastAtS = 0.0;
};

// Looks for a start after which the programs do not keep together, and samples all runs after it,
// or started at once, every kTogetherStepS, for each two machines: bodies that move against all bodies
// of the other machine, but its obstacles only as far as they are checked against those of their
// own cell, and heads and arms against the material that the other has laid by then. Preconditions:
// as for commonClock; all programs state the arm. Throws Cancelled.
inline constexpr double kTogetherStepS = 0.02;
SharedRun runTogether(std::span<const RunningMachine> machines, const base::RunContext& ctx);

} // namespace voluta::replay
