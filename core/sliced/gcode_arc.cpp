#include "sliced/gcode_arc.h"

#include "program/common/arc.h"

#include <algorithm>
#include <cmath>

namespace voluta::sliced {

namespace {
using Eigen::Vector2d, Eigen::Vector3d;

// By centre, else by radius.
std::optional<Vector2d> vectorToCentre(const GcodeArc& arc) {
  if (arc.toCentre)
    return arc.toCentre;
  const Vector2d chord = (arc.to - arc.from).head<2>();
  const double half = 0.5 * chord.norm();
  if (!arc.radiusMm || !(half > 0.0))
    return std::nullopt;
  const double radius = std::abs(*arc.radiusMm);
  constexpr double kRounding = 1e-3;
  if (radius < half * (1.0 - kRounding))
    return std::nullopt;
  const double height = std::sqrt(std::max(0.0, radius * radius - half * half));
  const Vector2d left(-chord.y(), chord.x());
  const double side = (arc.clockwise ? -1.0 : 1.0) * (*arc.radiusMm < 0.0 ? -1.0 : 1.0);
  return Vector2d(0.5 * chord + side * height / (2.0 * half) * left);
}
} // namespace

std::optional<std::vector<Vector3d>> pointsOf(const GcodeArc& arc) {
  constexpr double kSagittaMm = 0.005, kOffMm = 0.05, kOffShare = 0.01, kMaxPieces = 1e5;
  const std::optional<Vector2d> centreOffset = vectorToCentre(arc);
  if (!centreOffset)
    return std::nullopt;
  const Vector3d centre = arc.from + Vector3d(centreOffset->x(), centreOffset->y(), 0.0);
  Vector3d level = arc.to;
  level.z() = arc.from.z();
  const auto circle =
      program::arcAbout(centre, (arc.clockwise ? -1.0 : 1.0) * Vector3d::UnitZ(), arc.from, level);
  if (!circle || circle->distanceMm(level) > std::max(kOffMm, kOffShare * circle->radiusMm))
    return std::nullopt;
  const double step = std::sqrt(8.0 * kSagittaMm / circle->radiusMm);
  const double count = std::clamp(std::ceil(circle->sweepRad / step), 1.0, kMaxPieces);
  std::vector<Vector3d> points;
  for (double k = 1.0; k < count; ++k) {
    Vector3d point = circle->at(circle->sweepRad * k / count);
    point.z() += k / count * (arc.to.z() - arc.from.z());
    points.push_back(point);
  }
  points.push_back(arc.to);
  return points;
}

} // namespace voluta::sliced
