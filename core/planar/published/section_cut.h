// Cuts that fulfil RoboFDM's constraints.
#pragma once

#include "planar/piece_cut.h"
#include "planar/planar_decomposition.h"
#include "planar/plate_contact.h"

#include <cstdint>
#include <optional>

namespace voluta::planar {

// PlanarOptions::lowestZ for constraint II (RoboFDM, phase III: all base planes need to
// face up).
inline constexpr double kFacesUp = 0.0;

// Constraint I (RoboFDM, phase III): base cross-sections should not intersect each other.
enum class SectionContact {
  Apart,    // they have no point in common
  MayTouch, // a new one may end at an old one; none passes through another
};

// As splitPiece, but returns nullopt if no nearby plane can be closed, if the plane's normal is
// lower than options.lowestZ, if the sections would violate `sections`, or if the remaining contact
// with the plate would be less than options.keptContact and keptHull of the part's `footing`.
std::optional<PieceCut> constrainedCut(const Piece& piece, const Plane& plane, std::int32_t tag,
                                       const Wanted& wanted, const PlanarOptions& options,
                                       const Footing& footing, SectionContact sections);

} // namespace voluta::planar
