#include "geometry/far_field.h"

#include <Eigen/Geometry>
#include <cmath>

namespace voluta::geometry {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void FarFieldSums::addTriangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d vector = 0.5 * (b - a).cross(c - a), sum = a + b + c;
  const double size = vector.norm();
  area += size;
  weighted += size * sum / 3.0;
  normal += vector;
  first += sum * vector.transpose() / 3.0;
  const Matrix3d square =
      (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose()) / 12.0;
  for (std::size_t i = 0; i < 3; ++i)
    second[i] += vector[static_cast<Eigen::Index>(i)] * square;
}

void FarFieldSums::add(const FarFieldSums& other) {
  area += other.area;
  weighted += other.weighted;
  normal += other.normal;
  first += other.first;
  for (std::size_t i = 0; i < 3; ++i)
    second[i] += other.second[i];
}

FarField::FarField(const FarFieldSums& sums, const Vector3d& origin, const Vector3d& low,
                   const Vector3d& high) {
  centre_ =
      sums.area > 0.0 ? Vector3d(origin + sums.weighted / sums.area) : Vector3d(0.5 * (low + high));
  radius_ = (centre_ - low).cwiseMax(high - centre_).norm();
  normal_ = sums.normal;
  const Vector3d d = centre_ - origin;
  const Matrix3d first = sums.first - d * sums.normal.transpose();
  trace_ = first.trace();
  quadratic_ = {first(0, 0),
                first(1, 1),
                first(2, 2),
                first(0, 1) + first(1, 0),
                first(0, 2) + first(2, 0),
                first(1, 2) + first(2, 1)};
  std::array<Matrix3d, 3> q;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const Vector3d m = sums.first.col(k);
    q[i] =
        sums.second[i] - d * m.transpose() - m * d.transpose() + sums.normal[k] * d * d.transpose();
  }
  // Coefficients of q(r, r, r): xxx yyy zzz xxy xxz xyy yyz xzz yzz xyz.
  cubic_ = {q[0](0, 0),
            q[1](1, 1),
            q[2](2, 2),
            2 * q[0](0, 1) + q[1](0, 0),
            2 * q[0](0, 2) + q[2](0, 0),
            2 * q[1](0, 1) + q[0](1, 1),
            2 * q[1](1, 2) + q[2](1, 1),
            2 * q[2](0, 2) + q[0](2, 2),
            2 * q[2](1, 2) + q[1](2, 2),
            2 * (q[0](1, 2) + q[1](0, 2) + q[2](0, 1))};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    cubicTrace_ += 2.0 * q[i].col(k);
    cubicTrace_[k] += q[i].trace();
  }
}

double FarField::solidAngle(const Vector3d& p) const {
  const Vector3d r = centre_ - p;
  const double x = r.x(), y = r.y(), z = r.z();
  const double squared = r.squaredNorm(), inverse = 1.0 / squared;
  const double inverseCube = inverse * std::sqrt(inverse);
  const double quadratic = x * (quadratic_[0] * x + quadratic_[3] * y + quadratic_[4] * z) +
                           y * (quadratic_[1] * y + quadratic_[5] * z) + quadratic_[2] * z * z;
  const double cubic = x * x * (cubic_[0] * x + cubic_[3] * y + cubic_[4] * z) +
                       y * y * (cubic_[1] * y + cubic_[5] * x + cubic_[6] * z) +
                       z * z * (cubic_[2] * z + cubic_[7] * x + cubic_[8] * y) +
                       cubic_[9] * x * y * z;
  // The gradient of -1/r and its first two derivatives.
  return inverseCube * (normal_.dot(r) + trace_ - 3.0 * quadratic * inverse +
                        inverse * (7.5 * cubic * inverse - 1.5 * cubicTrace_.dot(r)));
}

} // namespace voluta::geometry
