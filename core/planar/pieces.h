// Pieces of a part cut by planes: their bases, print directions and risky faces.
#pragma once

#include "planar/plane_cut.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::planar {

inline constexpr std::int32_t kPlate = -2; // Piece::baseTag of pieces on the plate

// A solid that is printed in layers parallel to its base plane, upwards along its normal.
struct Piece {
  TaggedMesh solid;
  Plane base; // no part of the piece is below it
  // the cut whose section the piece is printed on; later pieces are printed on its sections of
  // other cuts
  std::int32_t baseTag = kPlate;
  int parent = -1; // index of the piece it is printed on; -1: the plate
  // All pieces that hold a share of the section it is printed on, including `parent` (the largest
  // share): later cuts may divide a section, but all of it exists before the piece is printed.
  std::vector<int> under;
};

// The rule for faces that need support (dissertation, eq. 2.1).
struct RiskRule {
  double overhangRad = 0.7853981633974483; // alpha: largest overhang angle that needs no support
  // Faces up to this height above the plate count as on the plate: half the first layer. A layer's
  // outline is the section at its middle, and the first layer is on the plate entirely. At a higher
  // flat face, the second layer would reach out over the first by more than alpha allows.
  double contactMm = 0.4;
};

// Returns the part as one piece on the plate z = 0; triangles are split at contactMm so that the
// contact area consists of whole faces.
Piece wholePart(const geometry::TriangleMesh& part, const RiskRule& rule);

// Returns whether n . d + sin(alpha) < 0: a face with outward unit normal n, printed along unit
// vector d, needs support.
bool isRisky(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction, const RiskRule& rule);

// Returns whether each triangle needs support if the piece is printed along its base's normal.
// Faces that the piece stands on do not: its base section and faces tagged kOnPrinted, and on the
// plate the faces up to contactMm (whole faces: see wholePart).
std::vector<bool> riskyFaces(const Piece& piece, const RiskRule& rule);
// Returns the area of these faces [mm2].
double riskyArea(const Piece& piece, const RiskRule& rule);

// Returns per triangle whether the piece stands on it.
std::vector<std::uint8_t> standsOn(const Piece& piece, const RiskRule& rule);

// Returns the tags of the sections that later pieces are printed on, sorted.
std::vector<std::int32_t> sectionsHeld(const Piece& piece);

// Returns the area of the section that the piece is printed on [mm2]; for a piece on the plate, its
// contact area.
double baseArea(const Piece& piece, const RiskRule& rule);

} // namespace voluta::planar
