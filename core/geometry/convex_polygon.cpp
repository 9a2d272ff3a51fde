#include "geometry/convex_polygon.h"

#include <algorithm>

namespace voluta::geometry {

std::vector<Eigen::Vector2d> convexPolygon(std::vector<Eigen::Vector2d> points) {
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

} // namespace voluta::geometry
