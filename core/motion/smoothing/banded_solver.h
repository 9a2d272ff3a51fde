// Symmetric equations whose unknowns each share one with few neighbours: solved in linear time.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace voluta::motion {

// Row i: the diagonal, then what it shares with unknowns i + 1, i + 2, ... (0 beyond the last).
template <std::size_t kWidth> using BandedRows = std::vector<std::array<double, kWidth>>;

// x with A x = b by Cholesky's factors L D L'. False where A is not positive definite, to rounding;
// x is of no use then. Precondition: as many rows as b. There for rows of 4, 8, ... 20 (jerks of
// one to five unknowns a point).
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
