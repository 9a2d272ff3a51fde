// The platform of planar mode: the plate that was chosen, on what carries it in the cell.
#pragma once

#include "planar/decomposition.h"
#include "process/process.h"
#include "project/job.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace voluta::modes {

// `own`: the polygon that the part brought along, which "fit" then stands for; where there is none,
// "fit" is a plate made for the first piece. Throws Error{Usage}: the platform or cell chosen.
planar::PlanarPlatform planarPlatform(const project::Choices& choices,
                                      const process::Process& process,
                                      const std::vector<Eigen::Vector2d>& own);

// What carries the plate in the chosen cell, as text for keys.
std::string carrierText(const project::Choices& choices, const process::Process& process);

} // namespace voluta::modes
