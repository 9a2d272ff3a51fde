#include "planar/head_reach.h"

#include "geometry/measures.h"

#include <algorithm>
#include <cmath>

namespace voluta::planar {

using Eigen::Vector3d;

std::vector<Vector3d> surfaceSamples(const geometry::TriangleMesh& mesh, double spacingMm) {
  std::vector<Vector3d> points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    const double longest =
        std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    const int n = std::clamp(static_cast<int>(std::ceil(longest / spacingMm)), 1, 200);
    // Centres of the n^2 like triangles, of slivers only as many as their area asks for.
    const double area = geometry::triangleArea(mesh, t);
    const int every =
        std::max(1, static_cast<int>(n * n * spacingMm * spacingMm / (2.0 * area + 1e-9) / 4.0));
    int at = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j, ++at)
        if (at % every == 0)
          points.push_back(a + (b - a) * ((i + 1.0 / 3.0) / n) + (c - a) * ((j + 1.0 / 3.0) / n));
  }
  return points;
}

std::vector<Vector3d> plateSamples(const std::vector<Eigen::Vector2d>& polygon, double spacingMm) {
  std::vector<Vector3d> points;
  if (polygon.size() < 3)
    return points;
  geometry::TriangleMesh fan;
  for (const auto& p : polygon)
    fan.vertices.emplace_back(p.x(), p.y(), 0.0);
  for (int i = 1; i + 1 < static_cast<int>(polygon.size()); ++i)
    fan.triangles.push_back({0, i, i + 1});
  points = surfaceSamples(fan, spacingMm);
  for (std::size_t i = 0; i < fan.vertices.size(); ++i) {
    const Vector3d &a = fan.vertices[i], &b = fan.vertices[(i + 1) % fan.vertices.size()];
    const int n = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacingMm)));
    for (int k = 0; k < n; ++k)
      points.push_back(a + (b - a) * (static_cast<double>(k) / n));
  }
  return points;
}

double blockedShare(const std::vector<Vector3d>& tips, const std::vector<Vector3d>& obstacles,
                    const Vector3d& direction, const process::HeadShape& head) {
  if (tips.empty() || head.sections.empty())
    return 0.0;
  constexpr double kTouching = 1e-3; // mm
  double lowest = 1e300;
  for (const Vector3d& t : tips)
    lowest = std::min(lowest, direction.dot(t));
  const double top = head.sections.back().zMm;
  std::vector<Vector3d> near;
  for (const Vector3d& o : obstacles)
    if (direction.dot(o) > lowest + kTouching)
      near.push_back(o);
  const auto radiusAt = [&](double z) {
    double radius = 0.0;
    for (std::size_t s = 0; s + 1 < head.sections.size(); ++s) {
      const auto &a = head.sections[s], &b = head.sections[s + 1];
      if (z < a.zMm || z > b.zMm)
        continue;
      const double rise = b.zMm - a.zMm;
      radius = std::max(radius, rise <= 0.0
                                    ? std::max(a.radiusMm, b.radiusMm)
                                    : a.radiusMm + (b.radiusMm - a.radiusMm) * (z - a.zMm) / rise);
    }
    return radius;
  };
  std::size_t blocked = 0;
  for (const Vector3d& t : tips)
    blocked += std::any_of(near.begin(), near.end(), [&](const Vector3d& o) {
      const Vector3d to = o - t;
      const double z = direction.dot(to);
      if (z <= kTouching || z > top)
        return false;
      const double reach = radiusAt(z) - kTouching;
      return reach > 0.0 && to.squaredNorm() - z * z < reach * reach;
    });
  return static_cast<double>(blocked) / static_cast<double>(tips.size());
}

} // namespace voluta::planar
