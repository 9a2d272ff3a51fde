#include "layers/part_boundary.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "voxel/triangle_box.h"

#include <algorithm>
#include <cmath>

namespace voluta::layers {

namespace {

constexpr double kMaxCellsAlong = 400.0;

} // namespace

PartBoundary::PartBoundary(const geometry::TriangleMesh& part, double cellMm,
                           const base::RunContext& ctx)
    : query_(part) {
  base::require(cellMm > 0.0, "a positive width of cells");
  normal_.resize(part.triangles.size());
  point_.resize(part.triangles.size());
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    normal_[t] = geometry::triangleNormal(part, t);
    point_[t] = part.corner(t, 0);
  }
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  if (box.isEmpty())
    return;
  cell_ = std::max(cellMm, box.sizes().maxCoeff() / kMaxCellsAlong);
  low_ = box.min().array() - cell_;
  size_ = ((box.sizes() / cell_).array().ceil().cast<int>() + 3).matrix();
  near_.assign(static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y()) *
                   static_cast<std::size_t>(size_.z()),
               0);
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    if (t % 4096 == 0)
      ctx.checkpoint();
    // Slightly wider than the cells, so that a facet on the boundary of two cells marks both.
    const voxel::TriangleBoxTest test(part.corner(t, 0), part.corner(t, 1), part.corner(t, 2),
                                      0.5 * cell_ * (1.0 + 1e-6));
    Eigen::AlignedBox3d of(part.corner(t, 0));
    of.extend(part.corner(t, 1)).extend(part.corner(t, 2));
    const double hair = 1e-6 * cell_;
    const Eigen::Vector3i from = ((of.min() - low_).array() - hair)
                                     .array()
                                     .cwiseQuotient(Eigen::Array3d::Constant(cell_))
                                     .floor()
                                     .cast<int>()
                                     .max(0)
                                     .matrix();
    const Eigen::Vector3i to = ((of.max() - low_).array() + hair)
                                   .array()
                                   .cwiseQuotient(Eigen::Array3d::Constant(cell_))
                                   .floor()
                                   .cast<int>()
                                   .matrix()
                                   .cwiseMin(size_ - Eigen::Vector3i::Ones());
    for (int k = from.z(); k <= to.z(); ++k)
      for (int j = from.y(); j <= to.y(); ++j)
        for (int i = from.x(); i <= to.x(); ++i) {
          const Eigen::Vector3d centre = low_ + cell_ * Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5);
          if (test.overlaps(centre))
            near_[static_cast<std::size_t>(i) +
                  static_cast<std::size_t>(size_.x()) *
                      (static_cast<std::size_t>(j) +
                       static_cast<std::size_t>(size_.y()) * static_cast<std::size_t>(k))] = 1;
        }
  }
}

bool PartBoundary::mayCross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
  if (near_.empty())
    return false;
  for (int axis = 0; axis < 3; ++axis) {
    const double high = low_[axis] + cell_ * size_[axis];
    if (std::max(a[axis], b[axis]) < low_[axis] || std::min(a[axis], b[axis]) > high)
      return false;
  }
  Eigen::Vector3i from, to;
  for (int axis = 0; axis < 3; ++axis) {
    const double minimum = std::min(a[axis], b[axis]), maximum = std::max(a[axis], b[axis]);
    from[axis] = std::max(0, static_cast<int>(std::floor((minimum - low_[axis]) / cell_)));
    to[axis] =
        std::min(size_[axis] - 1, static_cast<int>(std::floor((maximum - low_[axis]) / cell_)));
  }
  for (int k = from.z(); k <= to.z(); ++k)
    for (int j = from.y(); j <= to.y(); ++j)
      for (int i = from.x(); i <= to.x(); ++i)
        if (near_[static_cast<std::size_t>(i) +
                  static_cast<std::size_t>(size_.x()) *
                      (static_cast<std::size_t>(j) +
                       static_cast<std::size_t>(size_.y()) * static_cast<std::size_t>(k))] != 0)
          return true;
  return false;
}

void PartBoundary::crossings(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double minGapMm,
                             std::vector<Crossing>& out) const {
  thread_local std::vector<geometry::MeshQuery::Hit> hits;
  out.clear();
  query_.hits(a, b, hits);
  if (hits.empty())
    return;
  const Eigen::Vector3d step = b - a;
  const auto enters = [&](int triangle) { return normal(triangle).dot(step) < 0.0; };
  // The number of shells that contain the start: as many as are left before they are entered.
  int depth = 0, minimum = 0;
  for (const auto& hit : hits) {
    depth += enters(hit.triangle) ? 1 : -1;
    minimum = std::min(minimum, depth);
  }
  depth = -minimum;
  const double length = step.norm();
  for (const auto& hit : hits) {
    const bool wasInside = depth > 0;
    depth += enters(hit.triangle) ? 1 : -1;
    if (wasInside == (depth > 0))
      continue;
    if (!out.empty() && (hit.t - out.back().t) * length < minGapMm)
      out.pop_back();
    else
      out.push_back({hit.t, hit.triangle, !wasInside});
  }
}

} // namespace voluta::layers
