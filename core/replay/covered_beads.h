// The time after which beads are covered by others, by the clock of a run.
#pragma once

#include "plan/layer_times.h"
#include "replay/covering_times.h"
#include "replay/program_run.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// Returns for each piece the last earlier one directly below the middle third of its width;
// kNeverFilled if there is none, and for waste. Throws Cancelled.
std::vector<std::uint32_t> piecesBelow(const std::vector<BeadPiece>& pieces,
                                       const PrintedPart& printed, const GroundProbe& ground,
                                       const base::RunContext& ctx);

struct CoveredPlace {
  double timeS = 0.0; // since the bead below was deposited there
  std::size_t motion = 0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero(); // the nozzle's tip [mm]
};
struct CoveredBeads {
  LayerTimeFigures figures;
  std::optional<CoveredPlace> shortest, longest;
  // Length of beads that cover another one too early or too late, by more than 2 % of the limit.
  double youngMm = 0.0, oldMm = 0.0;
};
// Both times are those of the middles of the pieces. `below` as from piecesBelow(); `firstPiece` as
// from firstPieceOfMotions(), for the motions of `run`. Beads on those printed before a resumed
// program begins are left out.
CoveredBeads coveredBeads(const std::vector<DepositedPiece>& pieces,
                          const std::vector<std::uint32_t>& below,
                          const std::vector<std::uint32_t>& firstPiece, const Run& run,
                          const plan::LayerTimes& limits);

} // namespace voluta::replay
