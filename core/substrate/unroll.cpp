#include "substrate/unroll.h"

#include "base/error.h"

#include <cmath>

namespace voluta::substrate {

Unrolled unroll(const Eigen::Vector3d& p) {
  const double radius = std::hypot(p.y(), p.z());
  return {radius * std::atan2(p.z(), p.y()), p.x(), radius};
}

Eigen::Vector3d roll(const Unrolled& p) {
  base::require(p.radiusMm > 0.0, "a radius to roll up at");
  const double angle = p.aroundMm / p.radiusMm;
  return {p.alongMm, p.radiusMm * std::cos(angle), p.radiusMm * std::sin(angle)};
}

Eigen::Vector2d flattened(const Eigen::Vector2d& p, const std::function<double(double)>& heightMm) {
  return {p.x(), p.y() + heightMm(0.0) - heightMm(p.x())};
}

double arcLength(const std::function<double(double)>& slope, double a, double b) {
  // Simpson's rule, halved until it stays.
  const auto speed = [&](double t) { return std::hypot(1.0, slope(t)); };
  constexpr int kMostHalvings = 20;
  const double ends = speed(a) + speed(b);
  double inner = 0.0, last = 0.0;
  for (int k = 1; k <= kMostHalvings; ++k) {
    const long pieces = 1L << k;
    const double step = (b - a) / static_cast<double>(pieces);
    double middles = 0.0;
    for (long i = 1; i < pieces; i += 2)
      middles += speed(a + step * static_cast<double>(i));
    const double length = step / 3.0 * (ends + 4.0 * middles + 2.0 * inner);
    inner += middles;
    if (k > 5 && std::abs(length - last) <= 1e-11 * length)
      return length;
    last = length;
  }
  return last;
}

} // namespace voluta::substrate
