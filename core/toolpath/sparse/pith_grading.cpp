#include "toolpath/sparse/pith_grading.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace voluta::toolpath {

namespace {
// Some lines are left below the skin, so that it is carried.
constexpr double kMaxSwing = 0.8;
} // namespace

double PithGrading::densityAt(double mm) const {
  return deepestMm > 0.0 ? mean - swing * std::cos(base::kPi * mm / deepestMm) : density;
}

double PithGrading::evenMm(double mm) const {
  if (!(deepestMm > 0.0))
    return mm;
  const double wave = deepestMm / base::kPi * std::sin(base::kPi * mm / deepestMm);
  return (mean * mm - swing * wave) / density;
}

PithGrading pithGrading(std::span<const double> mm, std::span<const double> area, double density) {
  base::require(mm.size() == area.size() && density > 0.0 && density < 1.0,
                "pithGrading: an area a place, and a density");
  PithGrading grading;
  grading.density = grading.mean = density;
  for (const double d : mm)
    grading.deepestMm = std::max(grading.deepestMm, d);
  double sum = 0.0, waves = 0.0;
  for (std::size_t i = 0; i < mm.size() && grading.deepestMm > 0.0; ++i)
    if (mm[i] > 0.0) {
      sum += area[i];
      waves -= area[i] * std::cos(base::kPi * mm[i] / grading.deepestMm);
    }
  if (!(sum > 0.0))
    return grading;
  // Of mean + swing x wave = density, with the greatest swing that keeps it between 0 and 1.
  const double wave = kMaxSwing * waves / sum;
  grading.mean = density / (1.0 + wave);
  if (grading.mean > 0.5)
    grading.mean = (density - wave) / (1.0 - wave);
  grading.swing = kMaxSwing * std::min(grading.mean, 1.0 - grading.mean);
  return grading;
}

} // namespace voluta::toolpath
