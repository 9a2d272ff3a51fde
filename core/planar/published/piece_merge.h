// Pieces put together again.
#pragma once

#include "planar/pieces.h"

#include <optional>

namespace voluta::planar {

// `upper` and the piece `lower` that it stands on as one piece on lower's base: the section between
// them is taken out and its points joined. Nothing where `upper` stands on more than `lower`, lies
// on others' material besides, or reaches below lower's base.
std::optional<Piece> merged(const Piece& lower, const Piece& upper);

} // namespace voluta::planar
