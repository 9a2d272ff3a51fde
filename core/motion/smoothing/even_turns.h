// Smooths a sequence of angles (Whittaker's smoother).
#pragma once

#include <vector>

namespace voluta::motion {

// Minimises sum (x_i - y_i)^2 + lambda * sum (x_{i-1} - 2 x_i + x_{i+1})^2 over x. Waves shorter
// than about 2 pi lambda^(1/4) samples are removed; straight lines are preserved. lambda >= 0.
// Source: Eilers, A perfect smoother, Anal. Chem. 75 (2003).
std::vector<double> evened(const std::vector<double>& y, double lambda);

} // namespace voluta::motion
