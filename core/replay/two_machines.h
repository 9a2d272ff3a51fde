// Runs the programs of two machines in one time, with the signals of their marks, and looks for
// collisions between the two.
#pragma once

#include "base/text.h"
#include "plan/program.h"
#include "process/process.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// A program, as read back, and its cell in the frame that both machines share.
struct RunningMachine {
  const plan::ReadProgram& program;
  const robot::Cell& cell;
  const process::Process& process; // of the tool that the program begins with
  Eigen::Isometry3d shared_T_world = Eigen::Isometry3d::Identity();
};

// On a common clock: from the moment at which both programs are started.
struct MachineClock {
  std::vector<double> beginS, endS; // per motion
  double totalS = 0.0, waitS = 0.0; // waitS: at marks
  std::size_t marks = 0;
};

// A machine that waits for a signal which does not come.
struct Stuck {
  std::size_t machine = 0; // 0 or 1
  std::size_t file = 0, line = 0;
};

// Times of both programs; a machine that announces a mark goes on once it sees the signal of the
// other (plan/marks.h), at most kSignalS later.
inline constexpr double kSignalS = 0.05;
struct CommonClock {
  std::array<MachineClock, 2> machines;
  std::optional<Stuck> stuck; // the times are then those until then
};
// motionS: duration of each motion of each program [s].
CommonClock commonClock(const std::array<const plan::ReadProgram*, 2>& programs,
                        const std::array<std::vector<double>, 2>& motionS);

// A contact of the two; consecutive samples with the same bodies are one.
struct Meeting {
  double whenS = 0.0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero(); // shared frame [mm]
  base::Value first, second;                       // names of the bodies
};

// Distances are computed up to this [mm].
inline constexpr double kMachinesCapMm = 300.0;
struct TwoMachines {
  CommonClock clock;
  double makespanS = 0.0;
  std::size_t collisions = 0;
  std::vector<Meeting> meetings; // the first ones
  // Of moving bodies of the one to those of the other.
  double leastDistanceMm = kMachinesCapMm, leastAtS = 0.0;
};

// Samples both runs every kTogetherStepS: bodies that move against all bodies of the other machine,
// but its obstacles only as far as they are checked against those of their own cell, and heads and
// arms against the material that the other has laid by then. Preconditions: both programs state the
// arm. Throws Cancelled.
inline constexpr double kTogetherStepS = 0.02;
TwoMachines runTogether(const RunningMachine& a, const RunningMachine& b,
                        const base::RunContext& ctx);

} // namespace voluta::replay
