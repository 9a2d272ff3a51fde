#include "helpers/made_solids.h"

#include "base/error.h"
#include "base/units.h"
#include "helpers/lathe_parts.h"
#include "helpers/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace voluta::test {

namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;
using geometry::BooleanOperation;
using geometry::TriangleMesh;

TriangleMesh combined(BooleanOperation operation, const TriangleMesh& a, const TriangleMesh& b) {
  std::optional<TriangleMesh> m = geometry::meshBoolean(operation, a, b, false);
  base::require(m.has_value(), "made parts are closed and combine");
  return std::move(*m);
}
} // namespace

TriangleMesh operator+(const TriangleMesh& a, const TriangleMesh& b) {
  return combined(BooleanOperation::Union, a, b);
}
TriangleMesh operator-(const TriangleMesh& a, const TriangleMesh& b) {
  return combined(BooleanOperation::Difference, a, b);
}

TriangleMesh moved(TriangleMesh mesh, const Eigen::Isometry3d& to) {
  for (Vector3d& v : mesh.vertices)
    v = to * v;
  return mesh;
}

// A closed polygon of (radius, z), radius > 0, turned about z.
TriangleMesh turned(std::vector<Vector2d> section, int sides) {
  for (Vector2d& p : section)
    p = {p.y(), p.x()};
  TriangleMesh m = revolved(section, sides); // about x, from y to z
  for (Vector3d& v : m.vertices)
    v = Vector3d(v.y(), v.z(), v.x());
  return m;
}

// A round rod along a line of points, its ends flat.
TriangleMesh swept(const std::vector<Vector3d>& line, const std::vector<double>& radius,
                   int sides) {
  TriangleMesh m;
  const std::size_t n = line.size();
  Vector3d side = (line[1] - line[0]).unitOrthogonal();
  for (std::size_t k = 0; k < n; ++k) {
    const Vector3d along = (line[std::min(k + 1, n - 1)] - line[k == 0 ? 0 : k - 1]).normalized();
    side = (side - side.dot(along) * along).normalized();
    const Vector3d other = along.cross(side);
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * base::kPi * i / sides;
      m.vertices.push_back(line[k] + radius[k] * (std::cos(a) * side + std::sin(a) * other));
    }
  }
  const auto at = [&](std::size_t k, int i) { return static_cast<int>(k) * sides + i % sides; };
  for (std::size_t k = 1; k < n; ++k)
    for (int i = 0; i < sides; ++i) {
      m.triangles.push_back({at(k - 1, i), at(k - 1, i + 1), at(k, i + 1)});
      m.triangles.push_back({at(k - 1, i), at(k, i + 1), at(k, i)});
    }
  for (const std::size_t k : {std::size_t{0}, n - 1}) {
    const int centre = static_cast<int>(m.vertices.size());
    m.vertices.push_back(line[k]);
    for (int i = 0; i < sides; ++i)
      m.triangles.push_back(k == 0 ? std::array{centre, at(k, i + 1), at(k, i)}
                                   : std::array{centre, at(k, i), at(k, i + 1)});
  }
  return facingOutward(std::move(m));
}

TriangleMesh cylinder(const Vector3d& from, const Vector3d& to, double radius) {
  return swept({from, to}, {radius, radius}, 40);
}

} // namespace voluta::test
