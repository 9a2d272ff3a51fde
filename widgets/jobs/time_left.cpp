#include "jobs/time_left.h"

#include <algorithm>
#include <cmath>

namespace voluta::jobs {

namespace {
constexpr double kHiddenS = 2.0;
constexpr double kLeastFraction = 0.01;
constexpr double kSmoothingS = 5.0;
} // namespace

std::optional<double> TimeLeft::update(double elapsedS, double fraction) {
  const double passed = std::max(0.0, elapsedS - lastS_);
  lastS_ = elapsedS;
  if (fraction < kLeastFraction)
    return std::nullopt;
  const double now = elapsedS * (1.0 - std::min(fraction, 1.0)) / fraction;
  if (estimateS_) {
    const double counted = std::max(0.0, *estimateS_ - passed);
    estimateS_ = counted + (1.0 - std::exp(-passed / kSmoothingS)) * (now - counted);
  } else {
    estimateS_ = now;
  }
  return elapsedS < kHiddenS ? std::nullopt : estimateS_;
}

} // namespace voluta::jobs
