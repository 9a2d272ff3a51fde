#include "geometry/formats/polygon_facets.h"

#include <Eigen/Geometry>
#include <numeric>

namespace voluta::geometry {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

double orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

} // namespace

std::vector<std::array<std::size_t, 3>> triangulatePolygon(const std::vector<Vector3d>& polygon) {
  if (polygon.size() == 3)
    return {{0, 1, 2}};
  Vector3d normal = Vector3d::Zero(); // Newell
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    normal += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const double sign = normal[axis] < 0.0 ? -1.0 : 1.0;
  std::vector<Vector2d> flat;
  for (const Vector3d& p : polygon)
    flat.emplace_back(p[(axis + 1) % 3], sign * p[(axis + 2) % 3]);

  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> left(polygon.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  while (left.size() > 3) {
    const std::size_t n = left.size();
    bool found = false;
    for (std::size_t i = 0; i < n && !found; ++i) {
      const std::size_t a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
      if (orientation(flat[a], flat[b], flat[c]) <= 0.0)
        continue;
      found = true;
      for (const std::size_t p : left)
        if (p != a && p != b && p != c && orientation(flat[a], flat[b], flat[p]) >= 0.0 &&
            orientation(flat[b], flat[c], flat[p]) >= 0.0 &&
            orientation(flat[c], flat[a], flat[p]) >= 0.0)
          found = false;
      if (found) {
        triangles.push_back({a, b, c});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    if (!found)
      break;
  }
  for (std::size_t i = 1; i + 1 < left.size(); ++i)
    triangles.push_back({left[0], left[i], left[i + 1]});
  return triangles;
}

} // namespace voluta::geometry
