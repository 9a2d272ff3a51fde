#include "toolpath/sparse/branches.h"

#include "base/index.h"
#include "process/bead_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace voluta::toolpath {

namespace {
using base::at;

// Of the longest bridge, and of the longest one that may sag
constexpr double kBridgeShare = 0.85, kSaggingShare = 1.0;
constexpr double kLean = 0.4; // [beads] per layer
constexpr std::size_t kMaxBranchings = 3;
} // namespace

Branches::Branches(const SparsePattern& pattern, double periodMm, const process::Process& process,
                   bool maySag)
    : beadMm_(process.beadWidthMm) {
  const double longest =
      maySag ? kSaggingShare * process::saggingBridgeMm(process) : kBridgeShare * process.bridgeMm;
  double spacing = pattern.spacing * periodMm, span = pattern.span * periodMm;
  while (span - beadMm_ > longest && spacing > 4.0 * beadMm_ && layers_.size() < kMaxBranchings) {
    // The last branching ends where the spans between the branches are short enough.
    const double needed = 0.5 * spacing * (1.0 - (longest + beadMm_) / span);
    apart_.push_back(std::min(0.25 * spacing, std::max(0.5 * beadMm_, needed)));
    layers_.push_back(1 + std::max(0, static_cast<int>(std::ceil((apart_.back() - 0.5 * beadMm_) /
                                                                 (kLean * beadMm_)))));
    spacing *= 0.5;
    span *= 0.5;
  }
}

int Branches::layers() const {
  return std::accumulate(layers_.begin(), layers_.end(), 0);
}

int Branches::stageOf(int left) const {
  int done = layers() - left, stage = 0;
  while (done > 0)
    done -= layers_[at(stage++)];
  return stage;
}

Branching Branches::of(int left, int stage) const {
  if (stage == 0)
    return {};
  int done = layers() - left;
  for (int k = 0; k + 1 < stage; ++k)
    done -= layers_[at(k)];
  const int step = std::clamp(done, 1, layers_[at(stage - 1)]) - 1;
  return {stage - 1, std::min(apart_[at(stage - 1)], (0.5 + kLean * step) * beadMm_)};
}

Branches branchesOf(const process::Process& process, const ToolpathOptions& options) {
  const SparsePattern& pattern = sparsePattern(options.sparsePattern);
  const double hatch = process::hatchOf(process.beadWidthMm, process.layerHeightMm);
  return {pattern, pattern.periodMm(options.infillDensity, hatch, process.beadWidthMm), process,
          options.bridgesMaySag};
}

} // namespace voluta::toolpath
