// The published measure of jerk.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace voluta::test {

// Returns the weights of points i - 2 .. i + 2 in the third derivative at times[i] of the quartic
// through them (Dai 2020, eqs. 4.7-4.10; for even times eq. 4.11). Unlike jerkStencils(), it does
// not detect points that alternate back and forth. Preconditions: 2 <= i, i + 2 < times.size();
// times increase.
inline std::array<double, 5> fivePointJerk(const std::vector<double>& times, std::size_t i) {
  // Third derivative of each Lagrange polynomial at times[i] (t = 0): six times the negated sum of
  // the other points' times, divided by the product of the time differences. The term of t^4
  // vanishes at t = 0.
  std::array<double, 5> t{}, weights{};
  for (std::size_t k = 0; k < 5; ++k)
    t[k] = times[i + k - 2] - times[i];
  for (std::size_t k = 0; k < 5; ++k) {
    double divisor = 1.0, sum = 0.0;
    for (std::size_t m = 0; m < 5; ++m)
      if (m != k) {
        divisor *= t[k] - t[m];
        sum += t[m];
      }
    weights[k] = -6.0 * sum / divisor;
  }
  return weights;
}

} // namespace voluta::test
