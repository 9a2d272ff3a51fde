#include "platform/rod_shape.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <string>

namespace voluta::platform {

namespace {

constexpr int kMinSides = 180;

[[noreturn]] void refuse(const base::Message& what) {
  throw base::Error(base::ErrorCode::UnusableInput, what, "rod profile"_text,
                    "give pairs of x and radius in mm, x ascending"_text);
}

// Ratio of the distances of a side's middle and of its corners from the axis.
double flatness(int sides) {
  return sides == 0 ? 1.0 : std::cos(base::kPi / sides);
}

} // namespace

RodShape straightRod(double diameterMm, double lengthMm, int sides) {
  return {{{-0.5 * lengthMm, 0.5 * diameterMm}, {0.5 * lengthMm, 0.5 * diameterMm}}, sides};
}

void checkRod(const RodShape& rod) {
  const auto& p = rod.profile;
  if (p.size() < 2)
    refuse("a rod needs at least two points"_text);
  if (rod.sides < 0 || rod.sides == 1 || rod.sides == 2)
    refuse("a rod is round or has at least three sides"_text);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!p[i].allFinite() || p[i].y() <= 0.0)
      refuse(base::message("the radius at point {i} is not positive"_text, i + 1));
    if (i > 0 && p[i].x() < p[i - 1].x())
      refuse(base::message("x decreases at point {i}"_text, i + 1));
    if (i > 1 && p[i].x() == p[i - 2].x())
      refuse(base::message("point {i} is the third one at x = {x:.6g} mm"_text, i + 1,
                           base::number(p[i].x())));
  }
  if (p[1].x() == p[0].x() || p[p.size() - 2].x() == p.back().x())
    refuse("a step at the end of the rod"_text);
}

double radiusAt(const RodShape& rod, double x, double angle) {
  double radius = 0.0;
  for (std::size_t i = 0; i + 1 < rod.profile.size(); ++i) {
    const Eigen::Vector2d &a = rod.profile[i], &b = rod.profile[i + 1];
    if (x < a.x() || x > b.x() || a.x() == b.x())
      continue;
    const double t = (x - a.x()) / (b.x() - a.x());
    radius = std::max(radius, (1.0 - t) * a.y() + t * b.y());
  }
  if (rod.sides == 0)
    return radius;
  const double side = 2.0 * base::kPi / rod.sides;
  const double along = angle - side * std::floor(angle / side);
  return radius * flatness(rod.sides) / std::cos(along - 0.5 * side);
}

RadiusRange radiiBetween(const RodShape& rod, double x0, double x1) {
  const double from = std::max(x0, rod.profile.front().x()),
               to = std::min(x1, rod.profile.back().x());
  RadiusRange range{std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t i = 0; i + 1 < rod.profile.size(); ++i) {
    const Eigen::Vector2d &a = rod.profile[i], &b = rod.profile[i + 1];
    const double low = std::max(from, a.x()), high = std::min(to, b.x());
    if (low > high || a.x() == b.x())
      continue;
    for (const double x : {low, high}) {
      const double t = (x - a.x()) / (b.x() - a.x());
      const double radius = (1.0 - t) * a.y() + t * b.y();
      range.minMm = std::min(range.minMm, radius * flatness(rod.sides));
      range.maxMm = std::max(range.maxMm, radius);
    }
  }
  return range;
}

geometry::TriangleMesh meshOf(const RodShape& rod, double chordMm) {
  base::require(chordMm > 0.0, "a chord height");
  int n = rod.sides;
  if (n == 0) {
    double maximum = 0.0;
    for (const Eigen::Vector2d& p : rod.profile)
      maximum = std::max(maximum, p.y());
    const double step = 2.0 * std::acos(std::max(0.0, 1.0 - chordMm / maximum));
    n = std::max(kMinSides, static_cast<int>(std::ceil(2.0 * base::kPi / step)));
  }
  geometry::TriangleMesh mesh;
  for (const Eigen::Vector2d& p : rod.profile)
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * base::kPi * i / n;
      mesh.vertices.emplace_back(p.x(), p.y() * std::cos(angle), p.y() * std::sin(angle));
    }
  const int rings = static_cast<int>(rod.profile.size());
  const auto at = [n](int ring, int i) { return ring * n + i % n; };
  for (int ring = 0; ring + 1 < rings; ++ring)
    for (int i = 0; i < n; ++i) {
      const int a = at(ring, i), b = at(ring, i + 1), c = at(ring + 1, i + 1), d = at(ring + 1, i);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(rod.profile.front().x(), 0.0, 0.0);
  mesh.vertices.emplace_back(rod.profile.back().x(), 0.0, 0.0);
  for (int i = 0; i < n; ++i) {
    mesh.triangles.push_back({first, at(0, i + 1), at(0, i)});
    mesh.triangles.push_back({first + 1, at(rings - 1, i), at(rings - 1, i + 1)});
  }
  return mesh;
}

} // namespace voluta::platform
