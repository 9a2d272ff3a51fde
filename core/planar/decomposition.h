// What planar mode decides about a part: its pieces in print order.
#pragma once

#include "plan/finding.h"
#include "planar/pieces.h"
#include "process/process.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::planar {

struct PlanarOptions {
  RiskRule rule;
  process::HeadShape head;            // must clear what is printed earlier; empty: not asked
  std::vector<Eigen::Vector2d> plate; // convex polygon on z = 0 that the head must clear too
  double leastVolumeMm3 = 30.0;       // pieces smaller than that are not worth a cut
  // The search stops at this share of the risky area before, mm2/mm2.
  double target = 0.004;
  std::size_t beam = 8;               // partial results kept
  int normals = 240;                  // of cutting planes, over the directions asked for
  double lowestZ = -0.4;              // z of the least of them (constraint II: 0)
  double stepMm = 2.0;                // between offsets of planes
  std::size_t searchTriangles = 5000; // of the mesh that is searched
  int mostCuts = 24;
};

struct PlanarDecomposition {
  std::vector<Piece> pieces; // in print order: a piece after the one it stands on
  double riskyBeforeMm2 = 0.0, riskyMm2 = 0.0;
  double sectionMm2 = 0.0;       // of all cuts
  std::size_t blockedPieces = 0; // that the head does not reach everywhere
  plan::Findings findings;
  struct {
    double search = 0.0, cut = 0.0;
  } seconds;
};

// Pieces in an order in which each comes after the one it stands on and the head reaches it past
// those before it, as far as there is such an order; `blocked` counts those it does not reach
// everywhere. Sets Piece::parent.
std::vector<Piece> printOrder(std::vector<Piece> pieces, const PlanarOptions& options,
                              double spacingMm, std::size_t& blocked);

} // namespace voluta::planar
