// Cutting of a piece into the remainder and the pieces that are printed on the section.
#pragma once

#include "planar/pieces.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace voluta::planar {

// Conditions for cutting a solid off.
struct CutRules {
  RiskRule rule;
  double minGainMm2 = 1.0;
  double minVolumeMm3 = 30.0;
  double maxContactLossMm2 = 0.0; // largest loss of the piece's contact area
};

struct PieceCut {
  Piece below;
  std::vector<Piece> above;
  std::vector<Eigen::Vector3d> sectionMiddles; // of each piece in `above` [mm]
  double sectionMm2 = 0.0;
};

// Cuts off every solid above the plane that has less risky area when printed along the plane's
// normal; the sections are tagged `tag` + index. Returns nullopt if none gains, if part of the
// remainder would lose its base, or if no nearby plane can be closed.
std::optional<PieceCut> cutPiece(const Piece& piece, const Plane& plane, std::int32_t tag,
                                 const CutRules& rules);

// Cuts off the wanted solids above the plane. Returns nullopt if none is wanted or if part of the
// remainder or of a cut-off solid would have no base. Throws as cutByPlane.
std::optional<PieceCut> splitPiece(const Piece& piece, const Plane& plane, std::int32_t tag,
                                   const Wanted& wanted, const RiskRule& rule);

// Same, but returns nullopt if no nearby plane can be closed.
std::optional<PieceCut> splitIfItCloses(const Piece& piece, const Plane& plane, std::int32_t tag,
                                        const Wanted& wanted, const RiskRule& rule);

// Cuts off the solids above the plane whose section centroids are within 3 mm of the given ones.
// Otherwise as splitIfItCloses.
std::optional<PieceCut> cutOffAt(const Piece& piece, const Plane& plane, std::int32_t tag,
                                 const std::vector<Eigen::Vector3d>& sectionMiddles,
                                 const RiskRule& rule);

// Returns the cut with all solids above the plane as one piece, whose layers are printed together.
// Solids that are printed one after the other may block the head for each other. Precondition:
// `above` is not empty.
PieceCut joined(PieceCut cut);

// Returns whether every solid of the piece has contact with the piece's base.
bool allStands(const Piece& piece, const RiskRule& rule);

} // namespace voluta::planar
