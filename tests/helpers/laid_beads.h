// A plan's beads as the replay of a faithful program lays them.
#pragma once

#include "plan/tool_plan.h"
#include "process/bead_model.h"
#include "replay/depositor.h"

#include <cstdint>
#include <vector>

namespace voluta::test {

// A piece for each segment; BeadPiece::motion is the waypoint that it leads to.
inline std::vector<replay::BeadPiece> depositedBeads(const plan::ToolPlan& plan) {
  std::vector<replay::BeadPiece> pieces;
  for (std::size_t k = 0; k < plan.paths.size(); ++k) {
    const plan::ToolPath& path = plan.paths[k];
    double run = 0.0;
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
      const double length = (plan.position[i] - plan.position[i - 1]).norm();
      if (length < 1e-6)
        continue;
      const auto area = [&](std::size_t j) {
        return process::beadArea(static_cast<double>(plan.widthMm[j]),
                                 static_cast<double>(plan.heightMm[j]));
      };
      run += length;
      replay::BeadPiece piece;
      piece.from = plan.position[i - 1];
      piece.to = plan.position[i];
      piece.fromDirection = plan.direction[i - 1];
      piece.toDirection = plan.direction[i];
      piece.fromHeightMm = plan.heightMm[i - 1];
      piece.toHeightMm = plan.heightMm[i];
      piece.volumeMm3 = static_cast<float>(process::beadVolume(area(i - 1), area(i), length));
      piece.runMm = static_cast<float>(run);
      piece.run = static_cast<std::uint32_t>(k + 1);
      piece.motion = static_cast<std::uint32_t>(i);
      piece.ofPart = path.kind != plan::PathKind::Support && !plan::isWaste(path.kind);
      pieces.push_back(piece);
    }
  }
  return pieces;
}

} // namespace voluta::test
