#include "geometry/convex_polygon.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>

namespace voluta::geometry {

namespace {

std::vector<Eigen::Vector2d> hullOf(std::vector<Eigen::Vector2d> points) {
  if (points.empty())
    return points;
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Eigen::Vector2d> out;
  const auto chain = [&](auto first, auto last, std::size_t keep) {
    for (auto it = first; it != last; ++it) {
      while (out.size() >= keep + 2) {
        const Eigen::Vector2d a = out.back() - out[out.size() - 2], b = *it - out[out.size() - 2];
        if (a.x() * b.y() - a.y() * b.x() > 1e-9)
          break;
        out.pop_back();
      }
      out.push_back(*it);
    }
    out.pop_back();
  };
  chain(points.begin(), points.end(), 0);
  chain(points.rbegin(), points.rend(), out.size());
  return out;
}

} // namespace

std::vector<Eigen::Vector2d> convexPolygon(std::vector<Eigen::Vector2d> points, double marginMm) {
  base::require(marginMm >= 0.0, "convexPolygon: margin >= 0");
  std::vector<Eigen::Vector2d> polygon = hullOf(std::move(points));
  if (marginMm == 0.0)
    return polygon;
  // Minkowski sum with a 16-gon around the disc of the margin.
  std::vector<Eigen::Vector2d> widened;
  const double radius = marginMm / std::cos(base::kPi / 16.0);
  for (const Eigen::Vector2d& p : polygon)
    for (int i = 0; i < 16; ++i) {
      const double a = base::kPi * (2 * i + 1) / 16.0;
      widened.emplace_back(p + radius * Eigen::Vector2d(std::cos(a), std::sin(a)));
    }
  return hullOf(std::move(widened));
}

bool inConvexPolygon(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((b.x() - a.x()) * (point.y() - a.y()) - (b.y() - a.y()) * (point.x() - a.x()) < 0)
      return false;
  }
  return !polygon.empty();
}

} // namespace voluta::geometry
