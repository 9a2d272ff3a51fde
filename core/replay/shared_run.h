// Runs the programs of several machines in one time, with the signals of their marks, and looks for
// collisions between them.
#pragma once

#include "base/text.h"
#include "plan/program.h"
#include "process/process.h"
#include "replay/common_clock.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// A program, as read back, and its cell in the frame that all machines share.
struct PlacedProgram {
  const plan::ReadProgram& program;
  const robot::Cell& cell;
  const process::Process& process; // of the tool that the program begins with
  Eigen::Isometry3d shared_T_world = Eigen::Isometry3d::Identity();
  // Points on the centrelines of the beads that earlier runs have printed; work frame [mm].
  std::vector<Eigen::Vector3d> printedEarlier = {};
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
  double minDistanceMm = kMachinesCapMm, minDistanceAtS = 0.0;
};

// Looks for a start after which the programs do not keep together, and samples all runs after it,
// or started at once, every kTogetherStepS, for each two machines: bodies that move against all
// bodies of the other machine, but its obstacles only as far as they are checked against those of
// their own cell, and heads and arms against the material that the other has laid by then.
// Preconditions: as for commonClock; all programs state the arm. Throws Cancelled.
inline constexpr double kTogetherStepS = 0.02;
SharedRun runTogether(std::span<const PlacedProgram> machines, const base::RunContext& ctx);

} // namespace voluta::replay
