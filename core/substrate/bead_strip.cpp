#include "substrate/bead_strip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace voluta::substrate {

using Eigen::Vector3d;

namespace {

// Half the strip's width to the left of each point, in the surface's plane; longer at corners,
// where both sides end at their miter.
std::vector<Vector3d> lateralOffsets(const SeamCurve& curve, double widthMm) {
  constexpr double kSharpest = 0.5; // cosine of half the turn
  const std::size_t n = curve.points.size();
  std::vector<Vector3d> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    Vector3d before = (curve.points[i] - curve.points[(i + n - 1) % n]).normalized(),
             after = (curve.points[(i + 1) % n] - curve.points[i]).normalized();
    if (!curve.isClosed && i == 0)
      before = after;
    if (!curve.isClosed && i + 1 == n)
      after = before;
    const Vector3d side = curve.normals[i].cross(before + after).normalized();
    const double half = std::sqrt(std::max(0.0, 0.5 * (1.0 + before.dot(after))));
    out[i] = 0.5 * widthMm / std::max(kSharpest, half) * side;
  }
  return out;
}

} // namespace

layers::Patch stripPatch(const SeamCurve& curve, const StripSize& size) {
  const std::vector<Vector3d> lateral = lateralOffsets(curve, size.widthMm);
  const int n = static_cast<int>(curve.points.size());
  const int pieces = curve.isClosed ? n : n - 1;
  layers::Patch patch;
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    for (const double side : {1.0, -1.0}) {
      patch.surface.vertices.push_back(curve.points[i] + side * lateral[i] +
                                       0.5 * size.heightMm * curve.normals[i]);
      patch.direction.push_back(curve.normals[i]);
    }
  for (int i = 0; i < pieces; ++i) {
    const int left = 2 * i, right = left + 1, nextLeft = 2 * ((i + 1) % n),
              nextRight = nextLeft + 1;
    patch.surface.triangles.push_back({left, right, nextRight});
    patch.surface.triangles.push_back({left, nextRight, nextLeft});
  }
  patch.thicknessMm.assign(patch.direction.size(), size.heightMm);
  patch.clearDirection = patch.direction;
  return patch;
}

geometry::TriangleMesh stripSolid(const SeamCurve& curve, const StripSize& size) {
  const std::vector<Vector3d> lateral = lateralOffsets(curve, size.widthMm);
  const int n = static_cast<int>(curve.points.size());
  const int pieces = curve.isClosed ? n : n - 1;
  geometry::TriangleMesh solid;
  // Around the section: low left, low right, high right, high left.
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Vector3d up = size.heightMm * curve.normals[i];
    for (const Vector3d& corner :
         std::array<Vector3d, 4>{lateral[i], -lateral[i], up - lateral[i], up + lateral[i]})
      solid.vertices.push_back(curve.points[i] + corner);
  }
  for (int i = 0; i < pieces; ++i)
    for (int k = 0; k < 4; ++k) {
      const int a = 4 * i + k, b = 4 * i + (k + 1) % 4, next = 4 * ((i + 1) % n);
      const int c = next + k, d = next + (k + 1) % 4;
      solid.triangles.push_back({a, d, b});
      solid.triangles.push_back({a, c, d});
    }
  if (!curve.isClosed)
    for (const auto& t : {std::array<int, 3>{0, 1, 2}, {0, 2, 3}}) {
      const int last = 4 * (n - 1);
      solid.triangles.push_back(t);
      solid.triangles.push_back({last + t[0], last + t[2], last + t[1]});
    }
  return solid;
}

} // namespace voluta::substrate
