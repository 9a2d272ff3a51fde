// Cuts that keep to RoboFDM's constraints.
#pragma once

#include "planar/decomposition.h"
#include "planar/piece_cut.h"
#include "planar/plate.h"

#include <cstdint>
#include <optional>

namespace voluta::planar {

// The horizon for constraint II (RoboFDM, phase III: all base planes need to face up): least z of
// a base plane's normal.
inline constexpr double kFacesUp = 0.0;

// As splitPiece, but nothing where no plane near by can be closed, where a new section would meet
// an old one (RoboFDM, phase III, constraint I: base cross-sections should not intersect each
// other), or where what stands on the plate would keep less of `footing`, the part's, than
// options.keptContact and keptHull.
std::optional<PieceCut> constrainedCut(const Piece& piece, const Plane& plane, std::int32_t tag,
                                       const Wanted& wanted, const PlanarOptions& options,
                                       const Footing& footing);

} // namespace voluta::planar
