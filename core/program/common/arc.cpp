#include "program/common/arc.h"

#include "base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::program {

using Eigen::Vector3d;

Vector3d Arc::at(double angleRad) const {
  return centre + radiusMm * (std::cos(angleRad) * u + std::sin(angleRad) * v);
}

Vector3d Arc::directionAt(double angleRad) const {
  return std::cos(angleRad) * v - std::sin(angleRad) * u;
}

double Arc::angleOf(const Vector3d& point) const {
  return std::atan2((point - centre).dot(v), (point - centre).dot(u));
}

double Arc::distanceMm(const Vector3d& point) const {
  const double x = (point - centre).dot(u), y = (point - centre).dot(v);
  const double offset = (point - centre).dot(u.cross(v));
  return std::hypot(std::hypot(x, y) - radiusMm, offset);
}

std::optional<Arc> arcThrough(const Vector3d& from, const Vector3d& via, const Vector3d& to) {
  const Vector3d a = via - from, b = to - from;
  const Vector3d normal = a.cross(b);
  const double squared = normal.squaredNorm();
  if (!(squared > 1e-16 * a.squaredNorm() * b.squaredNorm()))
    return std::nullopt;
  const Vector3d toCentre =
      (b.squaredNorm() * normal.cross(a) + a.squaredNorm() * b.cross(normal)) / (2.0 * squared);
  return arcAbout(from + toCentre, normal, from, to);
}

std::optional<Arc> arcAbout(const Vector3d& centre, const Vector3d& axis, const Vector3d& from,
                            const Vector3d& to) {
  Arc arc;
  arc.centre = centre;
  arc.radiusMm = (from - centre).norm();
  if (!(arc.radiusMm > 0.0))
    return std::nullopt;
  arc.u = (from - centre) / arc.radiusMm;
  arc.v = axis.normalized().cross(arc.u).normalized();
  arc.sweepRad = arc.angleOf(to);
  if (arc.sweepRad <= 1e-9)
    arc.sweepRad += 2.0 * base::kPi;
  return arc;
}

std::vector<Vector3d> pointsAlong(const Arc& arc) {
  constexpr double kSagittaMm = 5e-4, kMaxPieces = 4096.0;
  const double step = std::sqrt(8.0 * kSagittaMm / arc.radiusMm);
  const int pieces = static_cast<int>(std::clamp(std::ceil(arc.sweepRad / step), 2.0, kMaxPieces));
  std::vector<Vector3d> points;
  points.reserve(static_cast<std::size_t>(pieces) - 1);
  for (int k = 1; k < pieces; ++k)
    points.push_back(arc.at(arc.sweepRad * k / pieces));
  return points;
}

} // namespace voluta::program
