// The platform of planar mode: the chosen plate and the bodies that carry it in the cell.
#pragma once

#include "planar/planar_decomposition.h"
#include "process/process.h"
#include "project/choices.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::modes {

// Returns the bodies that carry the plate in the chosen cell: its thickness and the frusta about z
// below it. Throws as cellOnAnyPlatform().
planar::PlanarPlatform carrierOf(const project::Choices& choices, const process::Process& process);

// Adds the chosen plate to `carrier`. `own`: polygon of the part's own platform. A plate of
// automatic size follows it, or is fitted to the first piece if `own` is empty. Throws Error{Usage}
// if `platform` is not a plate.
planar::PlanarPlatform planarPlatform(planar::PlanarPlatform carrier,
                                      const project::Platform& platform,
                                      const std::vector<Eigen::Vector2d>& own);

} // namespace voluta::modes
