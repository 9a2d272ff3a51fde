#include "project/specimens.h"

#include "base/units.h"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace voluta::project {

namespace {
using Eigen::Vector3d;
using geometry::TriangleMesh;

// Corners of a section of a bar: lower left, lower right, upper right, upper left, seen along it.
using Section = std::array<Vector3d, 4>;

// Returns the solid between consecutive sections.
TriangleMesh barOf(const std::vector<Section>& sections) {
  TriangleMesh mesh;
  for (const Section& section : sections)
    mesh.vertices.insert(mesh.vertices.end(), section.begin(), section.end());
  const auto add = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  const int last = 4 * (static_cast<int>(sections.size()) - 1);
  for (int i = 0; i < last; i += 4)
    for (int k = 0; k < 4; ++k) {
      const int next = (k + 1) % 4;
      add(i + k, i + 4 + k, i + 4 + next, i + next);
    }
  add(0, 1, 2, 3);
  add(last + 3, last + 2, last + 1, last);
  return mesh;
}

Section acrossX(double x, double halfWidth, double height) {
  return {Vector3d(x, halfWidth, 0), Vector3d(x, -halfWidth, 0), Vector3d(x, -halfWidth, height),
          Vector3d(x, halfWidth, height)};
}

// Returns sections about an axis along y, from +angle to -angle, between two surfaces.
TriangleMesh arcOf(double angleDeg, double halfWidth, int steps,
                   const std::function<Vector3d(double)>& lower,
                   const std::function<Vector3d(double)>& upper) {
  std::vector<Section> sections;
  for (int i = 0; i <= steps; ++i) {
    const double angle = base::degreesToRadians(angleDeg) * (static_cast<double>(i) / steps - 0.5);
    const Vector3d low = lower(angle), high = upper(angle), lateral(0, halfWidth, 0);
    sections.push_back({low + lateral, low - lateral, high - lateral, high + lateral});
  }
  return barOf(sections);
}

constexpr double kRadiusMm = 60.0, kBarDeg = 75.0, kMouldDeg = 80.0, kWidthMm = 10.0;
constexpr double kLayersMm = 7 * 0.6;
constexpr double kMouldBaseMm = 10.0; // below the lowest place of the cylinder

int facetsOf(double arcDeg, double facetDeg) {
  return std::max(1, static_cast<int>(std::lround(arcDeg / facetDeg)));
}

Vector3d onArc(double radius, double angle) {
  return {radius * std::sin(angle), 0.0, radius * std::cos(angle)};
}
} // namespace

TriangleMesh barSpecimen() {
  return barOf({acrossX(-125, 5, 5), acrossX(125, 5, 5)});
}

TriangleMesh dumbbellSpecimen() {
  constexpr double kHalfMm = 82.5, kEndMm = 9.5, kNeckMm = 6.5, kNeckHalfMm = 28.5, kFilletMm = 76;
  constexpr int kSteps = 24;
  const double run = std::sqrt(kFilletMm * kFilletMm - std::pow(kFilletMm - kEndMm + kNeckMm, 2));
  std::vector<Section> sections;
  const auto add = [&](double x, double half) { sections.push_back(acrossX(x, half, 3)); };
  add(-kHalfMm, kEndMm);
  for (int i = kSteps; i >= 0; --i) {
    const double x = run * i / kSteps;
    add(-kNeckHalfMm - x, kNeckMm + kFilletMm - std::sqrt(kFilletMm * kFilletMm - x * x));
  }
  for (int i = 0; i <= kSteps; ++i) {
    const double x = run * i / kSteps;
    add(kNeckHalfMm + x, kNeckMm + kFilletMm - std::sqrt(kFilletMm * kFilletMm - x * x));
  }
  add(kHalfMm, kEndMm);
  return barOf(sections);
}

TriangleMesh plateSpecimen() {
  constexpr double kLengthMm = 120, kPlateMm = 60, kThickMm = 3, kHoleMm = 10;
  // A multiple of 8, with a point at each corner of a square; rays are stretched to the plate's
  // sides.
  constexpr int kAround = 96;
  TriangleMesh mesh;
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2.0 * base::kPi * i / kAround;
    const Vector3d ray(std::cos(angle), std::sin(angle), 0);
    const double square = std::max(std::abs(ray.x()), std::abs(ray.y()));
    const Vector3d outer(0.5 * kLengthMm * ray.x() / square, 0.5 * kPlateMm * ray.y() / square, 0);
    const Vector3d up(0, 0, kThickMm), hole = kHoleMm * ray;
    for (const Vector3d& p : {outer, Vector3d(outer + up), Vector3d(hole + up), hole})
      mesh.vertices.push_back(p);
  }
  for (int i = 0; i < kAround; ++i)
    for (int k = 0; k < 4; ++k) {
      const int here = 4 * i, there = 4 * ((i + 1) % kAround), next = (k + 1) % 4;
      mesh.triangles.push_back({here + k, there + k, there + next});
      mesh.triangles.push_back({here + k, there + next, here + next});
    }
  return mesh;
}

TriangleMesh curvedSpecimen(double facetDeg) {
  return arcOf(
      kBarDeg, 0.5 * kWidthMm, facetsOf(kBarDeg, facetDeg),
      [](double a) { return onArc(kRadiusMm, a); },
      [](double a) { return onArc(kRadiusMm + kLayersMm, a); });
}

TriangleMesh mouldOfCurvedSpecimen(double facetDeg) {
  const double bottom =
      kRadiusMm * std::cos(base::degreesToRadians(0.5 * kMouldDeg)) - kMouldBaseMm;
  return arcOf(
      kMouldDeg, kWidthMm, facetsOf(kMouldDeg, facetDeg),
      [bottom](double a) { return Vector3d(onArc(kRadiusMm, a).x(), 0.0, bottom); },
      [](double a) { return onArc(kRadiusMm, a); });
}

} // namespace voluta::project
