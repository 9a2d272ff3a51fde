// What touches what while the program runs: the head, the arm, the platform, the part as laid so
// far. Distances are replay's own (distances.h).
#pragma once

#include "replay/beads.h"
#include "replay/distances.h"
#include "replay/executed_path.h"
#include "replay/ground.h"
#include "replay/printed_part.h"
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

// One contact, from the sample where it begins on; samples in a row with the same pair are one.
struct Clash {
  std::size_t motion = 0, lastMotion = 0; // of the first sample and of the last
  double whenS = 0.0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero(); // work frame, mm
  base::Value first, second;                       // names of what touched
  std::size_t samples = 1;
};

// The eroded head (process::erodedHead; it may be that deep in soft, rounded beads) along the
// nozzle's path, against material laid before and against the ground.
// A cell of the part, or of a body that is the ground, counts when its centre is in the head shrunk
// by another half cell: nearer the grid can't tell. The flat underside, which all beads lie under,
// is held against their sections themselves. Material of the last 2 bead widths of the same
// path doesn't count. `firstPiece`: per motion the index of the first piece that is its own or a
// later motion's, one entry more (beads.h: firstPieceOfMotions). Not looked at are motions of which
// `known` holds; empty: of none. Throws Cancelled.
std::vector<Clash> headClashes(const ExecutedPath& path, const std::vector<LaidPiece>& pieces,
                               const std::vector<std::uint32_t>& firstPiece,
                               const PrintedPart& printed, const Underside& underside,
                               const process::Process& process, const GroundSolids& ground,
                               const std::vector<char>& known, const base::RunContext& ctx);

// Bodies of the cell against each other (its checkedPairs, but head against platform: above) and,
// the head apart, against material laid before and a body that is the ground. Between samples
// bodies are followed by the distance they move at most, so that pairs far from each other are
// looked at only now and then. `known` as above. Empty when path.arm is false. Throws Cancelled.
std::vector<Clash> armClashes(const ExecutedPath& path,
                              const std::vector<std::uint32_t>& firstPiece,
                              const PrintedPart& printed, const GroundSolids& ground,
                              const robot::Cell& cell, const std::vector<char>& known,
                              const base::RunContext& ctx);

} // namespace voluta::replay
