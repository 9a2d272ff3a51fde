#include "motion/smoothing/even_turns.h"

#include <array>
#include <cstddef>

namespace voluta::motion {

std::vector<double> evened(const std::vector<double>& y, double lambda) {
  const std::size_t n = y.size();
  if (n < 3 || lambda <= 0.0)
    return y;
  // I + lambda D'D is banded: diagonal a, first b, second c; factored as L D L'.
  std::vector<double> a(n, 1.0), b(n, 0.0), c(n, 0.0);
  const std::array<double, 3> w = {1.0, -2.0, 1.0};
  for (std::size_t i = 0; i + 2 < n; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      a[i + k] += lambda * w[k] * w[k];
    b[i] += lambda * w[0] * w[1];
    b[i + 1] += lambda * w[1] * w[2];
    c[i] += lambda * w[0] * w[2];
  }
  std::vector<double> d(n), l1(n, 0.0), l2(n, 0.0), x(y);
  for (std::size_t i = 0; i < n; ++i) {
    d[i] = a[i];
    if (i >= 1)
      d[i] -= l1[i - 1] * l1[i - 1] * d[i - 1];
    if (i >= 2)
      d[i] -= l2[i - 2] * l2[i - 2] * d[i - 2];
    l1[i] = (b[i] - (i >= 1 ? l2[i - 1] * l1[i - 1] * d[i - 1] : 0.0)) / d[i];
    l2[i] = c[i] / d[i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (i >= 1)
      x[i] -= l1[i - 1] * x[i - 1];
    if (i >= 2)
      x[i] -= l2[i - 2] * x[i - 2];
  }
  for (std::size_t i = 0; i < n; ++i)
    x[i] /= d[i];
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n)
      x[i] -= l1[i] * x[i + 1];
    if (i + 2 < n)
      x[i] -= l2[i] * x[i + 2];
  }
  return x;
}

} // namespace voluta::motion
