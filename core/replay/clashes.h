// Collisions during the program between head, arm, platform and the part as printed so far. Uses
// replay's own distance functions (distances.h).
#pragma once

#include "replay/beads.h"
#include "replay/distances.h"
#include "replay/executed_path.h"
#include "replay/printed_part.h"
#include "replay/replay_ground.h"
#include "replay/underside.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// One contact of a pair of bodies. Consecutive samples with the same pair are one clash.
struct Clash {
  std::size_t motion = 0, lastMotion = 0; // of the first sample and of the last
  double whenS = 0.0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero(); // work frame [mm], at the first sample
  base::Value first, second;                       // names of the two bodies
  std::size_t samples = 1;
};

// Checks the eroded head (process::erodedHead; it may penetrate soft, rounded beads by that depth)
// along the nozzle's path against earlier material and the ground. A cell of the part, or of a body
// that serves as ground, counts if its centre is inside the head shrunk by another half cell, since
// the grid cannot resolve less. The flat underside, which is above all beads, is checked against
// the bead sections themselves. Material of the last 2 bead widths of the same path does not count.
// `firstPiece`: per motion the index of the first piece of this or a later motion, with one more
// entry (beads.h: firstPieceOfMotions). Motions for which `known` is true are skipped; empty: none.
// Throws Cancelled.
std::vector<Clash> headClashes(const ExecutedPath& path, const std::vector<DepositedPiece>& pieces,
                               const std::vector<std::uint32_t>& firstPiece,
                               const PrintedPart& printed, const Underside& underside,
                               const process::Process& process, const GroundSolids& ground,
                               const std::vector<char>& known, const base::RunContext& ctx);

// Checks the cell's bodies against each other (its checkedPairs except head against platform, see
// above), and all bodies but the head against earlier material and against a body that serves as
// ground. Between samples the maximum displacement of bodies bounds their distances, so that
// distant pairs are rarely evaluated. `known` as above. Returns an empty list if path.arm is false.
// Throws Cancelled.
std::vector<Clash> armClashes(const ExecutedPath& path,
                              const std::vector<std::uint32_t>& firstPiece,
                              const PrintedPart& printed, const GroundSolids& ground,
                              const robot::Cell& cell, const std::vector<char>& known,
                              const base::RunContext& ctx);

} // namespace voluta::replay
