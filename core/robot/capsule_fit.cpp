#include "robot/capsule_fit.h"

#include "base/error.h"
#include "base/units.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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
  if (twice == 0.0) { // on a line: the two that are farthest from each other
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

// Welzl's smallest circle, its recursion as loops. Points are taken by strides: in a mesh's order,
// one beside the other, nearly each would be outside what the ones before it gave.
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
  const Vector3d along = capsule.p1 - capsule.p0;
  const double square = along.squaredNorm();
  const double at = square > 0.0 ? std::clamp((p - capsule.p0).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - capsule.p0 - at * along).norm();
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
    const double aside = (seen[i] - circle.centre).norm();
    const double cap = std::sqrt(std::max(0.0, circle.radius * circle.radius - aside * aside));
    low = std::min(low, points[i].dot(axis) + cap);
    high = std::max(high, points[i].dot(axis) - cap);
  }
  if (low > high) // a ball
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

} // namespace

Capsule enclosingCapsule(const std::vector<Vector3d>& points, const Vector3d& alsoAlong) {
  base::require(!points.empty(), "points to enclose");
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& p : points)
    middle += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : points)
    spread += (p - middle) * (p - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(spread);
  std::vector<Vector3d> axes;
  for (int i = 0; i < 3; ++i)
    axes.push_back(principal.eigenvectors().col(i).normalized());
  if (alsoAlong.norm() > 0.0)
    axes.push_back(alsoAlong.normalized());
  Capsule best = around(points, axes.front());
  for (std::size_t i = 1; i < axes.size(); ++i)
    if (const Capsule other = around(points, axes[i]); volumeOf(other) < volumeOf(best))
      best = other;
  return best;
}

} // namespace voluta::robot
