// A piece cut in two or more: what stays, and what is printed on the section.
#pragma once

#include "planar/pieces.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace voluta::planar {

// What is worth cutting off, and what must be left.
struct CutRules {
  RiskRule rule;
  double leastGainMm2 = 1.0;
  double leastVolumeMm3 = 30.0;
  double maxContactLossMm2 = 0.0; // of what the piece stands on
};

struct PieceCut {
  Piece below;
  std::vector<Piece> above;
  std::vector<Eigen::Vector3d> sectionMiddles; // of each above, mm
  double sectionMm2 = 0.0;
};

// Cuts off every solid above the plane that gains by being printed along the plane's normal; the
// sections are tagged `tag` + place. Nothing where none gains, where a part of what stays would
// stand on nothing, or where no plane near by can be closed.
std::optional<PieceCut> cutPiece(const Piece& piece, const Plane& plane, std::int32_t tag,
                                 const CutRules& rules);

// Cuts off the wanted solids above the plane. Nothing where none is wanted or where a part of what
// stays, or what is cut off, would stand on nothing. Throws as cutByPlane.
std::optional<PieceCut> splitPiece(const Piece& piece, const Plane& plane, std::int32_t tag,
                                   const Wanted& wanted, const RiskRule& rule);

// The same, but nothing where no plane near by can be closed.
std::optional<PieceCut> splitIfItCloses(const Piece& piece, const Plane& plane, std::int32_t tag,
                                        const Wanted& wanted, const RiskRule& rule);

// Cuts off the solids above the plane whose sections have their middles within 3 mm of those given.
// Otherwise as splitIfItCloses.
std::optional<PieceCut> cutOffAt(const Piece& piece, const Plane& plane, std::int32_t tag,
                                 const std::vector<Eigen::Vector3d>& sectionMiddles,
                                 const RiskRule& rule);

// Whether each solid of the piece stands on what the piece stands on.
bool allStands(const Piece& piece, const RiskRule& rule);

} // namespace voluta::planar
