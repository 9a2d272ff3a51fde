#include "geometry/round_fit.h"

#include "geometry/least_squares.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::geometry {

namespace {

using Eigen::Vector3d;

double offMm(const RoundShape& shape, const Vector3d& point) {
  const Vector3d from = point - shape.centre;
  const double along = from.dot(shape.axis);
  const double radial = (from - along * shape.axis).norm() - shape.radiusMm;
  return shape.of == RoundShape::Of::Edge ? std::hypot(radial, along) : std::abs(radial);
}

bool areOn(const RoundShape& shape, const std::vector<Vector3d>& points) {
  return std::ranges::all_of(points, [&](const Vector3d& p) { return isOn(shape, p); });
}

// Solves |x - c|^2 = r^2 in the coordinates of `axes` (two or three columns), about the points'
// mean.
std::optional<RoundShape> fit(const std::vector<Vector3d>& points, const Eigen::MatrixXd& axes) {
  const Eigen::Index dim = axes.cols();
  if (static_cast<Eigen::Index>(points.size()) <= dim)
    return std::nullopt;
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points)
    mean += p / static_cast<double>(points.size());
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), dim + 1);
  Eigen::VectorXd right(rows.rows());
  double largest = 0.0;
  for (const Vector3d& p : points)
    largest = std::max(largest, (p - mean).norm());
  if (largest <= 0.0)
    return std::nullopt;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Eigen::VectorXd x =
        axes.transpose() * (points[static_cast<std::size_t>(i)] - mean) / largest;
    rows.row(i).head(dim) = 2.0 * x.transpose();
    rows(i, dim) = 1.0;
    right[i] = x.squaredNorm();
  }
  const LeastSquares solved = leastSquares(rows, right);
  if (solved.rank <= dim)
    return std::nullopt;
  const Eigen::VectorXd centre = solved.x.head(dim);
  const double squared = solved.x[dim] + centre.squaredNorm();
  if (!(squared > 0.0))
    return std::nullopt;
  RoundShape shape;
  shape.radiusMm = std::sqrt(squared) * largest;
  shape.centre = mean + axes * centre * largest;
  return shape;
}

} // namespace

bool isOn(const RoundShape& shape, const Vector3d& point) {
  constexpr double kShare = 2e-4, kSlackMm = 0.005;
  return offMm(shape, point) <= kShare * shape.radiusMm + kSlackMm;
}

bool isFacetOf(const RoundShape& shape, const std::array<Vector3d, 3>& corners,
               const Vector3d& normal) {
  constexpr double kSlackRad = 0.004;
  const auto across = [&](const Vector3d& v) -> Vector3d {
    return v - v.dot(shape.axis) * shape.axis;
  };
  double longestMm = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!isOn(shape, corners[k]))
      return false;
    longestMm = std::max(longestMm, across(corners[(k + 1) % 3] - corners[k]).norm());
  }
  const Vector3d out = across((corners[0] + corners[1] + corners[2]) / 3.0 - shape.centre);
  const double off = std::atan2(out.cross(normal).norm(), std::abs(out.dot(normal)));
  return off <= longestMm / shape.radiusMm + kSlackRad;
}

std::optional<RoundShape> circleThrough(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d u = b - a, v = c - a, normal = u.cross(v);
  constexpr double kLine = 1e-6; // sine of the angle at a
  if (normal.norm() <= kLine * u.norm() * v.norm())
    return std::nullopt;
  const Vector3d toCentre =
      (u.squaredNorm() * v.cross(normal) + v.squaredNorm() * normal.cross(u)) /
      (2.0 * normal.squaredNorm());
  return RoundShape{RoundShape::Of::Edge, toCentre.norm(), a + toCentre, normal.normalized()};
}

std::optional<RoundShape> cylinderThrough(const std::vector<Vector3d>& points,
                                          const Vector3d& axis) {
  if (axis.isZero())
    return std::nullopt;
  Eigen::MatrixXd across(3, 2);
  across.col(0) = axis.unitOrthogonal();
  across.col(1) = axis.cross(Vector3d(across.col(0)));
  auto shape = fit(points, across);
  if (!shape)
    return std::nullopt;
  shape->of = RoundShape::Of::Cylinder;
  shape->axis = axis;
  return areOn(*shape, points) ? shape : std::nullopt;
}

std::optional<RoundShape> sphereThrough(const std::vector<Vector3d>& points) {
  auto shape = fit(points, Eigen::Matrix3d::Identity());
  if (!shape)
    return std::nullopt;
  shape->of = RoundShape::Of::Sphere;
  return areOn(*shape, points) ? shape : std::nullopt;
}

RoundShape refined(const RoundShape& shape, const std::vector<Vector3d>& points) {
  return (shape.of == RoundShape::Of::Cylinder ? cylinderThrough(points, shape.axis)
                                               : sphereThrough(points))
      .value_or(shape);
}

} // namespace voluta::geometry
