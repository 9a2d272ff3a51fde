// The stiffness of beads: as of a composite of parallel fibres, alike in all directions across.
#pragma once

#include "elastic/hexahedron.h"
#include "process/material.h"
#include "process/process.h"

#include <Eigen/Core>
#include <optional>

namespace voluta::elastic {

// Of a material without directions.
Stiffness6 isotropicStiffness(double modulusMPa, double poisson);

// Of beads along a unit direction. Poisson's ratio is that of a strain across under a stress along,
// and between the directions across.
Stiffness6 beadStiffness(const process::Elasticity& elasticity, const Eigen::Vector3d& along);

// Of a tape, by the law of mixture: along it the moduli of fibres and matrix add by their shares of
// the volume, across it and in shear their inverses do (Voigt; Reuss). Nullopt if the process or
// the matrix does not state what that needs. Precondition: the process lays tape.
std::optional<process::Elasticity> tapeElasticity(const process::Process& tape,
                                                  const process::Elasticity& matrix);

} // namespace voluta::elastic
