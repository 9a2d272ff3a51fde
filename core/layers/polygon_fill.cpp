#include "layers/polygon_fill.h"

#include <algorithm>
#include <numeric>

namespace voluta::layers {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

} // namespace

std::vector<std::array<int, 3>> fillPolygon(const std::vector<Eigen::Vector2d>& corners) {
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> rest(corners.size());
  std::iota(rest.begin(), rest.end(), 0);
  const auto at = [&](int i) -> const Eigen::Vector2d& {
    return corners[static_cast<std::size_t>(i)];
  };
  double scale = 0.0;
  for (const Eigen::Vector2d& c : corners)
    scale = std::max(scale, (c - corners.front()).squaredNorm());
  const double zero = 1e-12 * scale;

  while (rest.size() > 3) {
    const std::size_t n = rest.size();
    std::size_t best = n, fallback = 0;
    double bestShape = 0.0, fallbackArea = -1e300;
    for (std::size_t k = 0; k < n; ++k) {
      const int ia = rest[(k + n - 1) % n], ib = rest[k], ic = rest[(k + 1) % n];
      const Eigen::Vector2d &a = at(ia), &b = at(ib), &c = at(ic);
      const double area = cross(a, b, c);
      if (area > fallbackArea) {
        fallbackArea = area;
        fallback = k;
      }
      if (area <= zero)
        continue;
      const bool empty = std::none_of(rest.begin(), rest.end(), [&](int i) {
        return i != ia && i != ib && i != ic && cross(a, b, at(i)) >= -zero &&
               cross(b, c, at(i)) >= -zero && cross(c, a, at(i)) >= -zero;
      });
      const double shape =
          area / ((a - b).squaredNorm() + (b - c).squaredNorm() + (c - a).squaredNorm());
      if (empty && (best == n || shape > bestShape)) {
        best = k;
        bestShape = shape;
      }
    }
    const std::size_t ear = best < n ? best : fallback;
    triangles.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  if (rest.size() == 3)
    triangles.push_back({rest[0], rest[1], rest[2]});
  return triangles;
}

} // namespace voluta::layers
