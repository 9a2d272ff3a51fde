// Displacements and stresses of cells under a load, linear elastic.
#pragma once

#include "base/run_context.h"
#include "elastic/hexahedron.h"
#include "elastic/load_case.h"

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace voluta::elastic {

struct ElasticState {
  // Per cell; zero outside the part. Of what fills the cell.
  std::vector<Tensor6> strain, stress;
  double workNmm = 0.0; // of all forces: the sum of force times displacement
};

// Returns the stiffness of what fills a cell [MPa].
using CellMaterial = std::function<Stiffness6(std::size_t cell)>;

// Solves the equilibrium by conjugate gradients; a cell is as much softer as it is less filled.
// Returns nullopt if it finds none. Throws Error{Usage} for a force on held places alone;
// Cancelled.
std::optional<ElasticState> foundEquilibrium(const LoadCase& load, const CellMaterial& material,
                                             const base::RunContext& ctx);
// As above. Also throws Error{UnusableInput} if it finds none.
ElasticState solved(const LoadCase& load, const CellMaterial& material,
                    const base::RunContext& ctx);

} // namespace voluta::elastic
