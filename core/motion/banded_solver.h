// Symmetric equations whose unknowns each share one with few neighbours: solved in linear time.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace voluta::motion {

// Row i: the diagonal, then what it shares with unknowns i + 1, i + 2, i + 3 (0 beyond the last).
using BandedRows = std::vector<std::array<double, 4>>;

// x with A x = b by Cholesky's factors L D L'. False where A is not positive definite, to rounding;
// x is of no use then. Precondition: as many rows as b.
bool solveBanded(const BandedRows& a, const std::vector<double>& b, std::vector<double>& x);

} // namespace voluta::motion
