#include "planar/head_reach.h"

#include "geometry/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

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

std::vector<Vector3d> plateSamples(const std::vector<Eigen::Vector2d>& polygon, double thicknessMm,
                                   double spacingMm) {
  if (polygon.size() < 3)
    return {};
  geometry::TriangleMesh plate;
  for (const auto& p : polygon) {
    plate.vertices.emplace_back(p.x(), p.y(), 0.0);
    plate.vertices.emplace_back(p.x(), p.y(), -thicknessMm);
  }
  const int n = static_cast<int>(plate.vertices.size());
  for (int i = 0; i < n; i += 2) {
    const int next = (i + 2) % n;
    plate.triangles.push_back({i, i + 1, next});
    plate.triangles.push_back({next, i + 1, next + 1});
    if (i >= 2 && i + 2 < n) {
      plate.triangles.push_back({0, i, i + 2});
      plate.triangles.push_back({1, i + 1, i + 3});
    }
  }
  std::vector<Vector3d> points = surfaceSamples(plate, spacingMm);
  points.insert(points.end(), plate.vertices.begin(), plate.vertices.end());
  return points;
}

std::vector<Vector3d> frustumSamples(double lowMm, double highMm, double lowRadiusMm,
                                     double highRadiusMm, double spacingMm) {
  std::vector<Vector3d> points;
  const auto ring = [&](double z, double radius) {
    const int n =
        std::max(6, static_cast<int>(std::ceil(2.0 * std::numbers::pi * radius / spacingMm)));
    for (int i = 0; i < n; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / n;
      points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z);
    }
  };
  const int steps =
      std::max(1, static_cast<int>(std::ceil(
                      std::hypot(highMm - lowMm, highRadiusMm - lowRadiusMm) / spacingMm)));
  for (int i = 0; i <= steps; ++i)
    ring(lowMm + (highMm - lowMm) * i / steps,
         lowRadiusMm + (highRadiusMm - lowRadiusMm) * i / steps);
  for (const auto& [z, radius] : {std::pair{lowMm, lowRadiusMm}, std::pair{highMm, highRadiusMm}})
    for (double r = radius - spacingMm; r > 0.0; r -= spacingMm)
      ring(z, r);
  return points;
}

namespace {

constexpr double kStepMm = 0.1;    // of heights in the table of radii
constexpr double kTouching = 1e-3; // mm
constexpr double kColumnMm = 1.0;  // of obstacles in a column so wide only the highest counts

struct Flat { // a point in the frame of a direction
  double u, v, h;
};

} // namespace

HeadReach::HeadReach(const process::HeadShape& head) {
  if (head.sections.empty())
    return;
  double radius = 0.0;
  std::size_t s = 0;
  for (double z = 0.0; z < head.sections.back().zMm; z += kStepMm) {
    while (s + 2 < head.sections.size() && head.sections[s + 1].zMm <= z)
      ++s;
    const auto &a = head.sections[s], &b = head.sections[std::min(s + 1, head.sections.size() - 1)];
    const double rise = b.zMm - a.zMm;
    radius = std::max(
        radius, rise > 0.0 ? a.radiusMm + (b.radiusMm - a.radiusMm) * (z - a.zMm) / rise : 0.0);
    const double reach = std::max(0.0, radius - kTouching);
    squared_.push_back(reach * reach);
  }
}

bool HeadReach::blocked(const std::vector<Vector3d>& tips, const std::vector<Vector3d>& obstacles,
                        const Vector3d& direction) const {
  if (tips.empty() || squared_.empty())
    return false;
  double lowest = 1e300;
  for (const Vector3d& t : tips)
    lowest = std::min(lowest, direction.dot(t));
  const Vector3d across = direction.unitOrthogonal(), along = direction.cross(across);
  std::vector<Flat> near;
  for (const Vector3d& o : obstacles)
    if (const double h = direction.dot(o); h > lowest + kTouching)
      near.push_back({across.dot(o), along.dot(o), h});
  if (near.empty())
    return false;
  const auto columnOf = [](const Flat& f) {
    return std::pair{std::lround(f.u / kColumnMm), std::lround(f.v / kColumnMm)};
  };
  std::sort(near.begin(), near.end(), [&](const Flat& a, const Flat& b) {
    const auto ca = columnOf(a), cb = columnOf(b);
    return ca != cb ? ca < cb : a.h > b.h;
  });
  near.erase(std::unique(near.begin(), near.end(),
                         [&](const Flat& a, const Flat& b) { return columnOf(a) == columnOf(b); }),
             near.end());
  std::sort(near.begin(), near.end(), [](const Flat& a, const Flat& b) { return a.h > b.h; });
  const double allowed = kBlockedShare * static_cast<double>(tips.size());
  // Strewn over the piece, so that what is blocked a lot is soon known to be.
  const std::size_t n = tips.size();
  std::size_t stride = std::max<std::size_t>(1, static_cast<std::size_t>(0.618 * n)) | 1U;
  while (std::gcd(stride, n) != 1)
    ++stride;
  std::size_t count = 0;
  for (std::size_t i = 0, at = 0; i < n; ++i, at = (at + stride) % n) {
    const Vector3d& t = tips[at];
    const double u = across.dot(t), v = along.dot(t), h = direction.dot(t) + kTouching;
    for (const Flat& o : near) {
      if (o.h <= h)
        break;
      const auto z = static_cast<std::size_t>((o.h - h) / kStepMm);
      if (z < squared_.size() && (o.u - u) * (o.u - u) + (o.v - v) * (o.v - v) < squared_[z]) {
        if (static_cast<double>(++count) > allowed)
          return true;
        break;
      }
    }
  }
  return false;
}

} // namespace voluta::planar
