// A part taken apart by planes: what is printed on what, and along which direction.
#pragma once

#include "planar/plane_cut.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::planar {

inline constexpr std::int32_t kPlate = -2; // Piece::baseTag of what stands on the plate

// A solid that is printed in layers parallel to its base plane, upwards along its normal.
struct Piece {
  TaggedMesh solid;
  Plane base;                    // nothing of the piece lies below it
  std::int32_t baseTag = kPlate; // the cut whose section it stands on; sections of other cuts are
                                 // what later pieces stand on
  int parent = -1;               // index of the piece it stands on; -1: the plate
  // All pieces that hold some of the section it stands on, `parent` (the largest share) among them:
  // a section may be shared after later cuts, all of it is there before the piece is printed.
  std::vector<int> under;
};

// When a face needs support: dissertation eq. 2.1.
struct RiskRule {
  double overhangRad = 0.7853981633974483; // alpha: how far a face may lean over without support
  // What lies this close over the plate lies on it: half the first layer. A layer's outline is the
  // section half-way up it, and the first lies on the plate all over; a flat face higher up has the
  // second layer reach out over the first by more than alpha allows.
  double contactMm = 0.4;
};

// The part as one piece that stands on the plate z = 0: split at contactMm, so that what lies on
// the plate is whole faces.
Piece wholePart(const geometry::TriangleMesh& part, const RiskRule& rule);

// n . d + sin(alpha) < 0: a face of outward unit normal n, printed along unit d, needs support.
bool isRisky(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction, const RiskRule& rule);

// Whether each triangle needs support where the piece is printed along its base's normal; none of
// what it stands on does: its base section and what is kLaid, and on the plate the faces that lie
// no higher than contactMm (whole: see wholePart).
std::vector<bool> riskyFaces(const Piece& piece, const RiskRule& rule);
// Their area, mm2.
double riskyArea(const Piece& piece, const RiskRule& rule);

// Whether each triangle is what the piece stands on.
std::vector<std::uint8_t> standsOn(const Piece& piece, const RiskRule& rule);

// Tags of the sections that later pieces stand on, sorted.
std::vector<std::int32_t> sectionsHeld(const Piece& piece);

// Area of the section that the piece stands on (of the plate: what lies on it). mm2.
double baseArea(const Piece& piece, const RiskRule& rule);

} // namespace voluta::planar
