// Findings about layers that all modes share.
#pragma once

#include "layers/absorb.h"
#include "layers/islands.h"
#include "plan/finding.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::layers {

// Pieces of layers that are not printed.
struct NotPrinted {
  std::size_t pieces = 0;
  double volumeMm3 = 0.0;
  Eigen::Vector3d largestAt = Eigen::Vector3d::Zero();
};
NotPrinted notPrinted(const std::vector<DroppedPiece>& dropped);

// Returns the finding "slivers" if there are any; it blocks from this share of the whole volume on.
std::optional<plan::Finding> sliversFinding(const NotPrinted& slivers, double depositedMm3,
                                            double blockingShare);

// Unsupported patches (IslandOptions::supportedShare).
struct InAir {
  std::size_t patches = 0;
  Eigen::Vector3d firstAt = Eigen::Vector3d::Zero();
};
InAir patchesInAir(const std::vector<SupportCheck>& support, const IslandOptions& options);

} // namespace voluta::layers
