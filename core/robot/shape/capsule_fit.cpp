#include "robot/shape/capsule_fit.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/principal_axes.h"
#include "geometry/triangle_queries.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace voluta::robot {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct Circle {
  Vector2d centre;
  double radius;
};
bool holds(const Circle& circle, const Vector2d& p) {
  return (p - circle.centre).norm() <= circle.radius * (1.0 + 1e-12) + 1e-12;
}
Circle through(const Vector2d& a, const Vector2d& b) {
  return {0.5 * (a + b), 0.5 * (a - b).norm()};
}
Circle through(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const Vector2d u = b - a, v = c - a;
  const double twice = 2.0 * (u.x() * v.y() - u.y() * v.x());
  if (twice == 0.0) { // Collinear: use the two points that are farthest apart
    Circle best = through(a, b);
    for (const Circle& other : {through(a, c), through(b, c)})
      if (other.radius > best.radius)
        best = other;
    return best;
  }
  const Vector2d at(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                    u.x() * v.squaredNorm() - v.x() * u.squaredNorm());
  return {a + at / twice, at.norm() / std::abs(twice)};
}

// Welzl's smallest enclosing circle, with its recursion as loops. Points are visited with a stride:
// in mesh order neighbours follow each other, and nearly each would be outside the previous circle.
Circle smallestCircle(const std::vector<Vector2d>& points) {
  std::size_t stride = points.size() * 5 / 8 + 1;
  while (std::gcd(stride, points.size()) != 1)
    ++stride;
  std::vector<Vector2d> p;
  p.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    p.push_back(points[i * stride % points.size()]);
  Circle circle{p.front(), 0.0};
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (holds(circle, p[i]))
      continue;
    circle = {p[i], 0.0};
    for (std::size_t j = 0; j < i; ++j) {
      if (holds(circle, p[j]))
        continue;
      circle = through(p[i], p[j]);
      for (std::size_t k = 0; k < j; ++k)
        if (!holds(circle, p[k]))
          circle = through(p[i], p[j], p[k]);
    }
  }
  return circle;
}

double toTenths(double mm) {
  return std::round(10.0 * mm) / 10.0;
}

double distanceTo(const Capsule& capsule, const Vector3d& p) {
  return geometry::distanceToSegment(p, capsule.p0, capsule.p1);
}

Capsule around(const std::vector<Vector3d>& points, const Vector3d& axis) {
  const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Vector2d> seen;
  seen.reserve(points.size());
  for (const Vector3d& p : points)
    seen.emplace_back(p.dot(u), p.dot(v));
  const Circle circle = smallestCircle(seen);
  double low = std::numeric_limits<double>::max(), high = -low;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double lateral = (seen[i] - circle.centre).norm();
    const double cap = std::sqrt(std::max(0.0, circle.radius * circle.radius - lateral * lateral));
    low = std::min(low, points[i].dot(axis) + cap);
    high = std::max(high, points[i].dot(axis) - cap);
  }
  if (low > high) // A ball
    low = high = 0.5 * (low + high);
  const Vector3d foot = circle.centre.x() * u + circle.centre.y() * v;
  Capsule capsule{(foot + low * axis).unaryExpr(&toTenths),
                  (foot + high * axis).unaryExpr(&toTenths), 0.0};
  for (const Vector3d& p : points)
    capsule.radius = std::max(capsule.radius, distanceTo(capsule, p));
  capsule.radius = std::max(0.1, std::ceil(10.0 * capsule.radius) / 10.0);
  return capsule;
}

double volumeOf(const Capsule& capsule) {
  const double r = capsule.radius;
  return base::kPi * r * r * ((capsule.p1 - capsule.p0).norm() + 4.0 / 3.0 * r);
}

Capsule around(const std::vector<Corners>& triangles, const Vector3d& alsoAlong) {
  std::vector<Vector3d> points;
  points.reserve(3 * triangles.size());
  for (const Corners& triangle : triangles)
    points.insert(points.end(), triangle.begin(), triangle.end());
  const auto less = [](const Vector3d& a, const Vector3d& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return enclosingCapsule(points, alsoAlong);
}

// A part of the mesh: a sample of its triangles, for finding cuts, and all triangles.
struct Part {
  std::vector<Corners> some, all;
  Capsule capsule{Vector3d::Zero(), Vector3d::Zero(), 0.0};
};

struct Cut {
  Plane plane;
  double volume; // Sum of both halves' capsules
};
std::optional<Cut> bestCut(const Part& part, const Vector3d& alsoAlong) {
  const Vector3d along = part.capsule.p1 - part.capsule.p0;
  const Vector3d u = along.norm() > 0.0 ? along.normalized() : Vector3d::UnitZ();
  const Vector3d v = u.unitOrthogonal();
  std::optional<Cut> best;
  for (const Vector3d& normal : {u, v, Vector3d(u.cross(v))}) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (const Corners& triangle : part.some)
      for (const Vector3d& p : triangle) {
        low = std::min(low, normal.dot(p));
        high = std::max(high, normal.dot(p));
      }
    for (const double share : {0.2, 0.35, 0.5, 0.65, 0.8}) {
      const Plane plane{normal, low + share * (high - low)};
      const auto sides = cut(part.some, plane);
      if (sides[0].empty() || sides[1].empty())
        continue;
      const double volume =
          volumeOf(around(sides[0], alsoAlong)) + volumeOf(around(sides[1], alsoAlong));
      if (!best || volume < best->volume)
        best = Cut{plane, volume};
    }
  }
  return best;
}

} // namespace

std::vector<Capsule> enclosingCapsules(const std::vector<Corners>& triangles,
                                       const Vector3d& alsoAlong, int maxParts) {
  constexpr std::size_t kSome = 2000;
  constexpr double kSaved = 1.0 / 6.0;
  base::require(!triangles.empty() && maxParts >= 1, "triangles to enclose");
  std::vector<Part> parts(1);
  const std::size_t stride = (triangles.size() + kSome - 1) / kSome;
  for (std::size_t t = 0; t < triangles.size(); t += stride)
    parts[0].some.push_back(triangles[t]);
  parts[0].all = triangles;
  parts[0].capsule = around(triangles, alsoAlong);
  while (static_cast<int>(parts.size()) < maxParts) {
    double whole = 0.0, saved = 0.0;
    std::size_t at = 0;
    Plane plane{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const double volume = volumeOf(parts[i].capsule);
      whole += volume;
      if (const auto found = bestCut(parts[i], alsoAlong);
          found && volume - found->volume > saved) {
        saved = volume - found->volume;
        at = i;
        plane = found->plane;
      }
    }
    if (saved < kSaved * whole)
      break;
    auto some = cut(parts[at].some, plane), all = cut(parts[at].all, plane);
    std::array<Part, 2> halves;
    for (std::size_t side = 0; side < 2; ++side) {
      halves[side].some = std::move(some[side]);
      halves[side].all = std::move(all[side]);
      halves[side].capsule = around(halves[side].all, alsoAlong);
    }
    parts[at] = std::move(halves[0]);
    parts.push_back(std::move(halves[1]));
  }
  std::vector<Capsule> capsules;
  for (const Part& part : parts)
    capsules.push_back(part.capsule);
  return capsules;
}

Capsule enclosingCapsule(const std::vector<Vector3d>& points, const Vector3d& alsoAlong) {
  base::require(!points.empty(), "points to enclose");
  const Eigen::Matrix3d principal = geometry::principalAxes(points);
  std::vector<Vector3d> axes;
  for (int i = 0; i < 3; ++i)
    axes.push_back(principal.col(i).normalized());
  if (alsoAlong.norm() > 0.0)
    axes.push_back(alsoAlong.normalized());
  Capsule best = around(points, axes.front());
  for (std::size_t i = 1; i < axes.size(); ++i)
    if (const Capsule other = around(points, axes[i]); volumeOf(other) < volumeOf(best))
      best = other;
  return best;
}

} // namespace voluta::robot
