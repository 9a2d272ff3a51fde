#include "sliced/ground_body.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace voluta::sliced {

namespace {
using Eigen::Vector3d;

constexpr double kMarginMm = 10.0, kThinMm = 5.0, kChordMm = 0.01;
constexpr double kMaxAngle = 0.499 * base::kPi;

void quad(geometry::TriangleMesh& mesh, int a, int b, int c, int d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

// Returns the distances along the ground from -most to most at which its chords are fine enough.
std::vector<double> stations(const CurvedGround& ground, double maxMm) {
  const double step =
      ground.isCurved() ? std::sqrt(8.0 * kChordMm * std::abs(ground.radiusMm)) : 2.0 * maxMm;
  const double count = std::max(1.0, std::ceil(2.0 * maxMm / step));
  std::vector<double> at;
  for (double k = 0.0; k <= count; ++k)
    at.push_back(-maxMm + 2.0 * maxMm * k / count);
  return at;
}

double withMargin(const CurvedGround& ground, double reachMm) {
  const double maximum = reachMm + kMarginMm;
  return ground.isCurved() ? std::min(maximum, kMaxAngle * std::abs(ground.radiusMm)) : maximum;
}

// A prism along x: its section is the strip below the ground.
geometry::TriangleMesh prism(const CurvedGround& ground, const Eigen::AlignedBox3d& part) {
  const double halfX = std::max(std::abs(part.min().x()), std::abs(part.max().x())) + kMarginMm;
  const double halfY =
      withMargin(ground, std::max(std::abs(part.min().y()), std::abs(part.max().y())));
  geometry::TriangleMesh mesh;
  const std::vector<double> at = stations(ground, halfY);
  double lowest = 0.0;
  for (const double y : at)
    lowest = std::min(lowest, ground.map({0.0, y, 0.0}).position.z());
  for (const double y : at) {
    const Vector3d top = ground.map({0.0, y, 0.0}).position;
    for (const double x : {-halfX, halfX}) {
      mesh.vertices.emplace_back(x, top.y(), top.z());
      mesh.vertices.emplace_back(x, top.y(), lowest - kThinMm);
    }
  }
  // Per station: top and bottom at the low x, top and bottom at the high x.
  const int last = static_cast<int>(at.size()) - 1;
  for (int k = 0; k < last; ++k) {
    const int a = 4 * k, b = a + 4;
    quad(mesh, a, a + 2, b + 2, b);         // Top
    quad(mesh, a + 1, b + 1, b + 3, a + 3); // Bottom
    quad(mesh, a, b, b + 1, a + 1);         // Low x
    quad(mesh, a + 2, a + 3, b + 3, b + 2); // High x
  }
  quad(mesh, 0, 1, 3, 2);
  const int e = 4 * last;
  quad(mesh, e, e + 2, e + 3, e + 1);
  return mesh;
}

// A cap: rings about the z axis.
geometry::TriangleMesh cap(const CurvedGround& ground, const Eigen::AlignedBox3d& part) {
  double reach = 0.0;
  for (const double x : {part.min().x(), part.max().x()})
    for (const double y : {part.min().y(), part.max().y()})
      reach = std::max(reach, std::hypot(x, y));
  reach = withMargin(ground, reach);
  const std::vector<double> both = stations(ground, reach);
  const int rings = std::max(2, static_cast<int>(both.size()) / 2);
  const int sectors = std::max(48, 4 * rings);
  geometry::TriangleMesh mesh;
  mesh.vertices.push_back(ground.map(Vector3d::Zero()).position);
  double lowest = 0.0;
  for (int ring = 1; ring <= rings; ++ring)
    for (int s = 0; s < sectors; ++s) {
      const double distance = reach * ring / rings, angle = 2.0 * base::kPi * s / sectors;
      mesh.vertices.push_back(
          ground.map({distance * std::cos(angle), distance * std::sin(angle), 0.0}).position);
      lowest = std::min(lowest, mesh.vertices.back().z());
    }
  const auto at = [&](int ring, int s) { return 1 + (ring - 1) * sectors + s % sectors; };
  for (int s = 0; s < sectors; ++s) {
    mesh.triangles.push_back({0, at(1, s), at(1, s + 1)});
    for (int ring = 1; ring < rings; ++ring)
      quad(mesh, at(ring, s), at(ring + 1, s), at(ring + 1, s + 1), at(ring, s + 1));
  }
  const int below = static_cast<int>(mesh.vertices.size());
  for (int s = 0; s < sectors; ++s) {
    Vector3d v = mesh.vertices[static_cast<std::size_t>(at(rings, s))];
    v.z() = lowest - kThinMm;
    mesh.vertices.push_back(v);
  }
  const int middle = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(0.0, 0.0, lowest - kThinMm);
  for (int s = 0; s < sectors; ++s) {
    const int next = (s + 1) % sectors;
    quad(mesh, at(rings, s), below + s, below + next, at(rings, s + 1));
    mesh.triangles.push_back({middle, below + next, below + s});
  }
  return mesh;
}
} // namespace

geometry::TriangleMesh groundBody(const CurvedGround& ground, const Eigen::AlignedBox3d& part) {
  return ground.shape == GroundShape::Sphere ? cap(ground, part) : prism(ground, part);
}

} // namespace voluta::sliced
