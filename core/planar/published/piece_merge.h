// Merging of pieces.
#pragma once

#include "planar/pieces.h"

#include <optional>

namespace voluta::planar {

// Returns `upper` and the piece `lower` it is printed on as one piece on lower's base; the section
// between them is removed and its points are joined. Returns nullopt if `upper` is printed on other
// pieces too, is on other earlier material, or extends below lower's base.
std::optional<Piece> merged(const Piece& lower, const Piece& upper);

} // namespace voluta::planar
