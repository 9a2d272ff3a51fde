#include "project/rib_samples.h"

#include "base/units.h"

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

namespace voluta::project {

namespace {

using Eigen::Vector2d;
using geometry::TriangleMesh;
using Outline = std::vector<Vector2d>; // y and z

constexpr double kBaseMm = 40.0, kBodyMm = 30.0, kRibMm = 6.57, kHeightMm = 0.25 + 9 * 0.2;
constexpr double kEavesMm = 8.0, kFromMm = 1.1;
constexpr int kArcSteps = 160, kRidgeSteps = 32;

// Makes a mesh from corners, each of them once, without triangles that have no extent.
class Builder {
public:
  // A planar face; corners in their order around its outward normal.
  void add(const std::vector<Eigen::Vector3d>& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const int a = at(corners[0]), b = at(corners[i - 1]), c = at(corners[i]);
      if (a != b && b != c && c != a)
        mesh_.triangles.push_back({a, b, c});
    }
  }
  TriangleMesh take() { return std::move(mesh_); }

private:
  int at(const Eigen::Vector3d& p) {
    const auto [found, isNew] =
        index_.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(mesh_.vertices.size()));
    if (isNew)
      mesh_.vertices.push_back(p);
    return found->second;
  }
  TriangleMesh mesh_;
  std::map<std::tuple<double, double, double>, int> index_;
};

Eigen::Vector3d along(double x, const Vector2d& p) {
  return {x, p.x(), p.y()};
}

// Returns the prism over a convex outline, counter-clockwise seen against x.
TriangleMesh prismOf(const Outline& outline, double lengthMm) {
  const double half = 0.5 * lengthMm;
  Builder builder;
  std::vector<Eigen::Vector3d> front, back;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    builder.add({along(-half, a), along(-half, b), along(half, b), along(half, a)});
    front.push_back(along(half, a));
    back.push_back(along(-half, outline[outline.size() - 1 - i]));
  }
  builder.add(front);
  builder.add(back);
  return builder.take();
}

// Returns the solid between two curves of equally many points from +y over the top to -y.
TriangleMesh ribOf(const Outline& inner, const Outline& outer) {
  const double half = 0.5 * kRibMm;
  Builder builder;
  for (std::size_t i = 0; i + 1 < inner.size(); ++i) {
    const Vector2d &a = inner[i], &b = inner[i + 1], &c = outer[i], &d = outer[i + 1];
    builder.add({along(-half, d), along(half, d), along(half, c), along(-half, c)});
    builder.add({along(-half, a), along(half, a), along(half, b), along(-half, b)});
    builder.add({along(half, c), along(half, d), along(half, b), along(half, a)});
    builder.add({along(-half, b), along(-half, d), along(-half, c), along(-half, a)});
  }
  builder.add({along(-half, outer.front()), along(half, outer.front()), along(half, inner.front()),
               along(-half, inner.front())});
  builder.add({along(-half, inner.back()), along(half, inner.back()), along(half, outer.back()),
               along(-half, outer.back())});
  return builder.take();
}

Vector2d onCircle(double radius, double angle) {
  return radius * Vector2d(std::cos(angle), std::sin(angle));
}

Outline arc(double radius, double from, double to, int steps) {
  Outline points;
  for (int i = 0; i <= steps; ++i)
    points.push_back(onCircle(radius, from + (to - from) * i / steps));
  return points;
}

double ridgeMm() {
  return 0.5 * kBaseMm * std::sqrt(3.0);
}

} // namespace

TriangleMesh gableRoof() {
  return prismOf({{-0.5 * kBaseMm, 0.0}, {0.5 * kBaseMm, 0.0}, {0.0, ridgeMm()}}, kBodyMm);
}

TriangleMesh ribOnRoof() {
  constexpr double kSlope = base::kPi / 6.0; // of the slopes' normals from horizontal
  const double down = 0.5 * kBaseMm - kEavesMm / std::sqrt(3.0);
  const Vector2d right(down, kEavesMm), left(-down, kEavesMm), ridge(0.0, ridgeMm());
  Outline inner{right}, outer{right + onCircle(kHeightMm, kSlope)};
  for (const Vector2d& p : arc(kHeightMm, kSlope, base::kPi - kSlope, kRidgeSteps)) {
    inner.push_back(ridge);
    outer.emplace_back(ridge + p);
  }
  inner.push_back(left);
  outer.emplace_back(left + onCircle(kHeightMm, base::kPi - kSlope));
  return ribOf(inner, outer);
}

TriangleMesh halfCylinder() {
  return prismOf(arc(0.5 * kBaseMm, 0.0, base::kPi, kArcSteps), kBodyMm);
}

TriangleMesh ribOnCylinder() {
  const double radius = 0.5 * kBaseMm, from = std::asin(kFromMm / radius);
  return ribOf(arc(radius, from, base::kPi - from, kArcSteps),
               arc(radius + kHeightMm, from, base::kPi - from, kArcSteps));
}

} // namespace voluta::project
