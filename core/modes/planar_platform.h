// The platform of planar mode: the plate that was chosen, on what carries it in the cell.
#pragma once

#include "planar/decomposition.h"
#include "process/process.h"
#include "project/choices.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::modes {

// What carries the plate in the chosen cell: its thickness and the frusta about z below it. Throws
// as cellOnAnyPlatform().
planar::PlanarPlatform carrierOf(const project::Choices& choices, const process::Process& process);

// `own`: the polygon that the part brought along, which a plate that is made for the part then
// follows; where there is none, that is made for the first piece. Throws Error{Usage}: what is no
// plate.
planar::PlanarPlatform planarPlatform(planar::PlanarPlatform carrier,
                                      const project::Platform& platform,
                                      const std::vector<Eigen::Vector2d>& own);

} // namespace voluta::modes
