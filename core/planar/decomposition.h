// What planar mode decides about a part: its pieces in print order.
#pragma once

#include "plan/finding.h"
#include "planar/pieces.h"
#include "process/process.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::planar {

// A frustum of what carries the plate, about the z axis. mm.
struct StemFrustum {
  double lowMm = 0.0, highMm = 0.0; // z, low < high <= 0
  double lowRadiusMm = 0.0, highRadiusMm = 0.0;
};

// What the part stands on, in its frame. The head must clear it whichever piece is printed.
struct PlanarPlatform {
  // Top of the plate on z = 0, convex, counter-clockwise; empty: the hull of what the first piece
  // stands on, marginMm wider, where the plate is made for the part. Then whatever else touches
  // z = 0 has nothing under it but what it is printed on.
  std::vector<Eigen::Vector2d> polygon;
  double marginMm = 0.0;
  double thicknessMm = 5.0;
  std::vector<StemFrustum> stem; // what carries the plate, in any order
};

struct PlanarOptions {
  RiskRule rule;
  process::HeadShape head; // must clear what is printed earlier; empty: not asked
  PlanarPlatform platform;
  double leastVolumeMm3 = 10.0; // pieces smaller than that are not worth a cut
  // The first piece keeps these shares of what the part stands on and of the hull of that, mm2/mm2;
  // where the target is not reached so, 0.4 of these shares (but 1 stays 1).
  double keptContact = 0.35, keptHull = 0.05;
  // What all of either is worth, in shares of the risky area before.
  double contactWeight = 0.1, hullWeight = 0.05;
  // The search stops at this share of the risky area before, mm2/mm2.
  double target = 0.008;
  std::size_t beam = 6;               // partial results kept
  int normals = 200;                  // of cutting planes, over the directions asked for
  double lowestZ = -0.71;             // z of the least of them (constraint II: 0)
  double stepMm = 2.0;                // between offsets of planes
  std::size_t searchTriangles = 4000; // of the mesh that is searched
  int mostCuts = 40;
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

// Pieces in an order in which each comes after all that it stands on and the head reaches it past
// those before it, as far as there is such an order; `blocked` counts those it does not reach
// everywhere. Sets Piece::parent and under.
std::vector<Piece> printOrder(std::vector<Piece> pieces, const PlanarOptions& options,
                              double spacingMm, std::size_t& blocked);

// The plate that the pieces are printed on: options.platform.polygon, or the one made for them.
std::vector<Eigen::Vector2d> plateOf(const std::vector<Piece>& pieces,
                                     const PlanarOptions& options);

} // namespace voluta::planar
