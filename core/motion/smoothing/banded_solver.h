// Linear-time solver for symmetric banded equations.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace voluta::motion {

// Row i: the diagonal, then the coefficients with unknowns i + 1, i + 2, ... (0 beyond the last).
template <std::size_t kWidth> using BandedRows = std::vector<std::array<double, kWidth>>;

// Solves A x = b with the factors L D L' (Cholesky). Returns false if A is not positive definite
// within rounding; x is then invalid. Precondition: as many rows as b. Instantiated for rows of 4,
// 8, ... 20 (jerks of one to five unknowns per point).
template <std::size_t kWidth>
bool solveBanded(const BandedRows<kWidth>& a, const std::vector<double>& b, std::vector<double>& x);

extern template bool solveBanded(const BandedRows<4>&, const std::vector<double>&,
                                 std::vector<double>&);
extern template bool solveBanded(const BandedRows<8>&, const std::vector<double>&,
                                 std::vector<double>&);
extern template bool solveBanded(const BandedRows<12>&, const std::vector<double>&,
                                 std::vector<double>&);
extern template bool solveBanded(const BandedRows<16>&, const std::vector<double>&,
                                 std::vector<double>&);
extern template bool solveBanded(const BandedRows<20>&, const std::vector<double>&,
                                 std::vector<double>&);

} // namespace voluta::motion
