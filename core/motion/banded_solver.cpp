#include "motion/banded_solver.h"

#include "base/error.h"

namespace voluta::motion {

bool solveBanded(const BandedRows& a, const std::vector<double>& b, std::vector<double>& x) {
  base::require(a.size() == b.size(), "solveBanded: as many rows as b");
  const std::size_t n = a.size();
  // factor[i][m]: of row i + m by column i.
  std::vector<std::array<double, 4>> factor(n);
  x = b;
  for (std::size_t i = 0; i < n; ++i) {
    std::array<double, 4> row = a[i];
    for (std::size_t back = 1; back <= 3 && back <= i; ++back) {
      const auto& f = factor[i - back];
      const double scaled = f[back] * f[0];
      for (std::size_t m = 0; back + m <= 3; ++m)
        row[m] -= scaled * f[back + m];
      x[i] -= f[back] * x[i - back];
    }
    if (!(row[0] > 0.0))
      return false;
    factor[i] = {row[0], row[1] / row[0], row[2] / row[0], row[3] / row[0]};
  }
  for (std::size_t i = n; i-- > 0;) {
    x[i] /= factor[i][0];
    for (std::size_t m = 1; m <= 3 && i + m < n; ++m)
      x[i] -= factor[i][m] * x[i + m];
  }
  return true;
}

} // namespace voluta::motion
