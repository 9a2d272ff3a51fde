#include "motion/smoothing/banded_solver.h"

#include "base/error.h"

namespace voluta::motion {

template <std::size_t kWidth>
bool solveBanded(const BandedRows<kWidth>& a, const std::vector<double>& b,
                 std::vector<double>& x) {
  base::require(a.size() == b.size(), "solveBanded: as many rows as b");
  const std::size_t n = a.size();
  // factor[i][m]: entry of row i + m in column i.
  BandedRows<kWidth> factor(n);
  x = b;
  for (std::size_t i = 0; i < n; ++i) {
    std::array<double, kWidth> row = a[i];
    for (std::size_t back = 1; back < kWidth && back <= i; ++back) {
      const auto& f = factor[i - back];
      const double scaled = f[back] * f[0];
      for (std::size_t m = 0; back + m < kWidth; ++m)
        row[m] -= scaled * f[back + m];
      x[i] -= f[back] * x[i - back];
    }
    if (!(row[0] > 0.0))
      return false;
    factor[i][0] = row[0];
    for (std::size_t m = 1; m < kWidth; ++m)
      factor[i][m] = row[m] / row[0];
  }
  for (std::size_t i = n; i-- > 0;) {
    x[i] /= factor[i][0];
    for (std::size_t m = 1; m < kWidth && i + m < n; ++m)
      x[i] -= factor[i][m] * x[i + m];
  }
  return true;
}

template bool solveBanded(const BandedRows<4>&, const std::vector<double>&, std::vector<double>&);
template bool solveBanded(const BandedRows<8>&, const std::vector<double>&, std::vector<double>&);
template bool solveBanded(const BandedRows<12>&, const std::vector<double>&, std::vector<double>&);
template bool solveBanded(const BandedRows<16>&, const std::vector<double>&, std::vector<double>&);
template bool solveBanded(const BandedRows<20>&, const std::vector<double>&, std::vector<double>&);

} // namespace voluta::motion
