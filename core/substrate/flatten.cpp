#include "substrate/flatten.h"

#include "base/error.h"

#include <cmath>

namespace voluta::substrate {

std::vector<FlatteningCircle> flatteningToPlane(const FlatteningCircle& start, double halfChordMm,
                                                double topThicknessMm, int layers,
                                                double endRadiusMm) {
  base::require(!start.isPlane() && start.radiusMm > 0.0 && endRadiusMm > 0.0,
                "circles to start from and to end with");
  base::require(topThicknessMm > 0.0 && layers >= 1 && halfChordMm > 0.0,
                "a positive thickness, width and number of layers");
  const double b = halfChordMm;
  // Avoids the cancellation in r - sqrt(r^2 - b^2).
  const auto heightOver = [b](double r) {
    if (b > r)
      throw base::Error(
          base::ErrorCode::UnusableInput,
          base::message("the feature is {width:.3g} mm wide, wider than its cylinder of "
                        "{cylinder:.3g} mm"_text,
                        base::number(2.0 * b), base::number(2.0 * r)),
          "flattening"_text, "make the feature narrower"_text);
    return std::isinf(r) ? 0.0 : b * b / (r + std::sqrt(r * r - b * b));
  };
  const double first = heightOver(start.radiusMm), last = heightOver(endRadiusMm);
  std::vector<FlatteningCircle> circles{start};
  for (int k = 1; k <= layers; ++k) {
    const double s = first + (last - first) * k / layers;
    circles.push_back({start.topMm + k * topThicknessMm,
                       k == layers ? endRadiusMm : (b * b + s * s) / (2.0 * s)});
  }
  return circles;
}

double thicknessAt(const FlatteningCircle& from, const FlatteningCircle& to, double alpha) {
  base::require(!from.isPlane(), "a circle to start from");
  const double r = from.radiusMm, sine = std::sin(alpha);
  if (to.isPlane())
    return sine > 0.0 ? (to.topMm - from.centreMm()) / sine - r
                      : std::numeric_limits<double>::quiet_NaN();
  const double down = from.centreMm() - to.centreMm();
  // The greater root of h^2 + 2 k1 h + k2 = 0, with k2 as a product to avoid cancellation.
  const double k1 = r + down * sine;
  const double k2 = (r - to.radiusMm) * (r + to.radiusMm) + down * down + 2.0 * r * down * sine;
  return -k1 + std::sqrt(k1 * k1 - k2);
}

} // namespace voluta::substrate
