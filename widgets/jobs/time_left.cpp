#include "jobs/time_left.h"

#include <algorithm>
#include <cmath>

namespace voluta::jobs {

namespace {
constexpr double kHiddenS = 2.0;
constexpr double kLeastFraction = 0.01;
constexpr double kSmoothingS = 5.0;
// A stroke: more than this between two looks, and at a pace that would end any run in seconds.
constexpr double kStroke = 0.02, kStrokePerS = 0.2;
} // namespace

std::optional<double> TimeLeft::update(double elapsedS, double fraction) {
  const double passed = std::max(0.0, elapsedS - lastS_);
  const double gained = fraction - fraction_;
  lastS_ = elapsedS;
  fraction_ = fraction;
  if (gained > 0.0)
    movedS_ = elapsedS;
  if (gained > kStroke && gained > kStrokePerS * passed)
    atOneStroke_ += gained;
  const double worked = fraction - atOneStroke_;
  if (worked < kLeastFraction)
    return std::nullopt;
  const double now = elapsedS * (1.0 - std::min(fraction, 1.0)) / worked;
  if (estimateS_) {
    const double counted = std::max(0.0, *estimateS_ - passed);
    estimateS_ = counted + (1.0 - std::exp(-passed / kSmoothingS)) * (now - counted);
  } else {
    estimateS_ = now;
  }
  if (elapsedS < kHiddenS || elapsedS - movedS_ > std::max(*estimateS_, 1.0))
    return std::nullopt;
  return estimateS_;
}

} // namespace voluta::jobs
