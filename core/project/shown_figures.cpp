#include "project/shown_figures.h"

#include "base/shown_number.h"

#include <algorithm>
#include <cmath>

namespace voluta::project {

namespace {
constexpr int kShareDecimals = 4, kLengthDecimals = 3;

// The limit on the side of 1 on which the ratio is.
double massLimit(double ratio, double tolerance) {
  return ratio < 1.0 ? 1.0 - tolerance : 1.0 + tolerance;
}
} // namespace

ReplayReport shownFigures(ReplayReport r) {
  for (const ItemReplayReport& item : r.items) {
    r.coveredFraction = std::min(r.coveredFraction, item.coveredFraction);
    r.thinFraction = std::max(r.thinFraction, item.thinFraction);
    r.unsupportedFraction = std::max(r.unsupportedFraction, item.unsupportedFraction);
    if (std::abs(item.massRatio - 1.0) > std::abs(r.massRatio - 1.0))
      r.massRatio = item.massRatio;
  }
  const ThresholdsReport& limits = r.thresholds;
  const auto atMost = [](double& value, double limit, int decimals) {
    if (value > limit)
      value = base::roundedBeyond(value, limit, decimals);
  };
  if (r.coveredFraction < limits.covered)
    r.coveredFraction = base::roundedBeyond(r.coveredFraction, limits.covered, kShareDecimals);
  atMost(r.thinFraction, limits.thin, kShareDecimals);
  atMost(r.unsupportedFraction, limits.unsupported, kShareDecimals);
  atMost(r.overfillFraction, limits.overfill, kShareDecimals);
  atMost(r.flowErrorFraction, limits.flowError, kShareDecimals);
  atMost(r.maxDeviationMm, limits.deviationMm, kLengthDecimals);
  if (std::abs(r.massRatio - 1.0) > limits.mass)
    r.massRatio =
        base::roundedBeyond(r.massRatio, massLimit(r.massRatio, limits.mass), kShareDecimals);
  return r;
}

} // namespace voluta::project
