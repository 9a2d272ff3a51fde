#include "toolpath/coverage/smooth_values.h"

#include <cstddef>

namespace voluta::toolpath {

void smoothValues(std::vector<double>& values, bool closed, int passes) {
  const std::size_t n = values.size();
  if (n < 3)
    return;
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<double> old = values;
    for (std::size_t i = 0; i < n; ++i) {
      const double before = i > 0 ? old[i - 1] : closed ? old[n - 1] : old[0];
      const double after = i + 1 < n ? old[i + 1] : closed ? old[0] : old[n - 1];
      values[i] = 0.25 * before + 0.5 * old[i] + 0.25 * after;
    }
  }
}

} // namespace voluta::toolpath
