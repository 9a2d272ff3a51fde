#include "jobs/time_left.h"

#include <algorithm>
#include <cmath>

namespace voluta::jobs {

namespace {
constexpr double kHiddenS = 2.0;
constexpr double kMinFraction = 0.01;
// Increasing estimates are adopted faster than decreasing ones.
constexpr double kSmoothingS = 5.0, kSmoothingLongerS = 1.0;
// A jump: more progress than kStroke between two updates, at a pace that would end any run in
// seconds.
constexpr double kStroke = 0.02, kStrokePerS = 0.2;
constexpr double kHalf = 0.5, kLastQuarter = 0.75; // Share of the run at which they begin
constexpr double kWithin = 2.0;                    // Factor
constexpr double kMinLeftS = 1.0;
constexpr double kApart = 0.005; // Share of the run between stored estimates
} // namespace

std::optional<double> TimeLeft::agreed(double elapsedS, double worked, double leftS, double left) {
  if (estimates_.empty() || elapsedS - estimates_.back().atS > kApart * elapsedS)
    estimates_.push_back({elapsedS, worked, elapsedS + leftS});
  while (estimates_.front().atS < kHalf * elapsedS)
    estimates_.pop_front();
  double minimum = std::max(leftS, kMinLeftS), maximum = minimum;
  const auto take = [&](double seconds) {
    minimum = std::min(minimum, std::max(seconds, kMinLeftS));
    maximum = std::max(maximum, seconds);
  };
  double recentS = leftS;
  const auto recent = std::ranges::find_if(
      estimates_, [&](const Estimate& e) { return e.atS >= kLastQuarter * elapsedS; });
  if (recent != estimates_.end() && elapsedS > recent->atS)
    recentS = left * (elapsedS - recent->atS) / std::max(worked - recent->worked, 1e-9);
  take(recentS);
  for (const Estimate& estimate : estimates_)
    take(estimate.endS - elapsedS);
  if (maximum > kWithin * minimum)
    return std::nullopt;
  return std::sqrt(leftS * recentS);
}

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
  if (worked < kMinFraction)
    return std::nullopt;
  const double left = 1.0 - std::min(fraction, 1.0);
  const std::optional<double> now = agreed(elapsedS, worked, elapsedS * left / worked, left);
  if (!now) {
    estimateS_.reset();
    return std::nullopt;
  }
  if (estimateS_) {
    const double counted = std::max(0.0, *estimateS_ - passed);
    const double smoothingS = *now > counted ? kSmoothingLongerS : kSmoothingS;
    estimateS_ = counted + (1.0 - std::exp(-passed / smoothingS)) * (*now - counted);
  } else {
    estimateS_ = now;
  }
  if (elapsedS < kHiddenS || elapsedS - movedS_ > std::max(*estimateS_, kMinLeftS))
    return std::nullopt;
  return estimateS_;
}

} // namespace voluta::jobs
