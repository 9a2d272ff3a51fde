// Cuts that fulfil RoboFDM's constraints.
#pragma once

#include "planar/decomposition.h"
#include "planar/piece_cut.h"
#include "planar/plate.h"

#include <cstdint>
#include <optional>

namespace voluta::planar {

// Minimum z of a base plane's normal for constraint II (RoboFDM, phase III: all base planes need to
// face up).
inline constexpr double kFacesUp = 0.0;

// As splitPiece, but returns nullopt if no nearby plane can be closed, if a new section would touch
// an old one (RoboFDM, phase III, constraint I: base cross-sections should not intersect each
// other), or if the remaining contact with the plate would be less than options.keptContact and
// keptHull of the part's `footing`.
std::optional<PieceCut> constrainedCut(const Piece& piece, const Plane& plane, std::int32_t tag,
                                       const Wanted& wanted, const PlanarOptions& options,
                                       const Footing& footing);

} // namespace voluta::planar
