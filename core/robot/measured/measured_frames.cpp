#include "robot/measured/measured_frames.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/directions.h"
#include "geometry/singular_values.h"
#include "geometry/symmetric_axes.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

base::Error unusable(const base::Message& what, const base::Message& remedy) {
  return {base::ErrorCode::UnusableInput, what, {}, remedy};
}

base::Error onALine() {
  return unusable("the points are on a line: the frame's rotation about it is undefined"_text,
                  "measure a point well off the line through the others"_text);
}

void requireFinite(bool finite) {
  if (!finite)
    throw unusable("a measured number is not finite"_text,
                   "remove the row, or measure it again"_text);
}

// Residual of the distances `errors`; `unknowns` of the fit.
Residual residualOf(const std::vector<Vector3d>& errors, int unknowns) {
  Residual residual;
  double squares = 0.0;
  for (const Vector3d& error : errors) {
    squares += error.squaredNorm();
    residual.worstMm = std::max(residual.worstMm, error.norm());
  }
  residual.rmsMm = std::sqrt(squares / static_cast<double>(errors.size()));
  const int spare = 3 * static_cast<int>(errors.size()) - unknowns;
  if (spare > 0)
    residual.noiseMm = std::sqrt(squares / spare);
  return residual;
}

double largestDeviation(const Matrix3d& covariance) {
  return std::sqrt(geometry::symmetricAxes(covariance).values.z());
}

Matrix3d crossed(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// Ratio of the second extent of points about their mean to the first.
double flatness(const Eigen::Matrix3Xd& aboutMean) {
  const Vector3d extents = geometry::singularValues(aboutMean);
  return extents.x() > 0.0 ? extents.y() / extents.x() : 0.0;
}

} // namespace

Eigen::Isometry3d frameFromPoints(const Vector3d& origin, const Vector3d& onX,
                                  const Vector3d& inPlane) {
  constexpr double kMinAngle = base::degreesToRadians(0.1);
  requireFinite(origin.allFinite() && onX.allFinite() && inPlane.allFinite());
  const Vector3d a = onX - origin, b = inPlane - origin, c = inPlane - onX;
  if (a.norm() == 0.0 || b.norm() == 0.0 || c.norm() == 0.0)
    throw unusable("two of the three points are identical"_text, "measure three points"_text);
  const double minimum = std::min({geometry::angleBetween(a, b), geometry::angleBetween(-a, b),
                                   geometry::angleBetween(a, c), geometry::angleBetween(a, -c),
                                   geometry::angleBetween(b, c), geometry::angleBetween(b, -c)});
  if (minimum < kMinAngle)
    throw onALine();
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.translation() = origin;
  frame.linear().col(0) = a.normalized();
  frame.linear().col(2) = a.cross(b).normalized();
  frame.linear().col(1) = frame.linear().col(2).cross(frame.linear().col(0));
  return frame;
}

MeasuredFrame frameFromPoints(const std::vector<TouchedPoint>& points) {
  constexpr double kMinFlatness = 1.0 / 500.0;
  const auto n = static_cast<Eigen::Index>(points.size());
  if (n < 3)
    throw unusable("a frame needs at least three points"_text, "measure another point"_text);
  Eigen::Matrix3Xd inFrame(3, n), inBase(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    inFrame.col(i) = points[static_cast<std::size_t>(i)].inFrame;
    inBase.col(i) = points[static_cast<std::size_t>(i)].inBase;
  }
  requireFinite(inFrame.allFinite() && inBase.allFinite());
  const Vector3d middle = inFrame.rowwise().mean(), middleInBase = inBase.rowwise().mean();
  const Eigen::Matrix3Xd from = inFrame.colwise() - middle, to = inBase.colwise() - middleInBase;
  if (flatness(from) < kMinFlatness || flatness(to) < kMinFlatness)
    throw onALine();
  const auto [u, v] = geometry::singularVectors(to * from.transpose());
  Vector3d signs = Vector3d::Ones();
  if ((u * v.transpose()).determinant() < 0.0)
    signs.z() = -1.0;
  MeasuredFrame measured;
  Eigen::Isometry3d& frame = measured.base_T_frame;
  frame.linear() = u * signs.asDiagonal() * v.transpose();
  frame.translation() = middleInBase - frame.linear() * middle;

  std::vector<Vector3d> errors;
  Matrix3d inertia = Matrix3d::Zero();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vector3d arm = frame.linear() * from.col(i);
    errors.push_back(to.col(i) - arm);
    inertia -= crossed(arm) * crossed(arm);
  }
  Residual& residual = measured.residual;
  residual = residualOf(errors, 6);
  if (residual.noiseMm) {
    // Gauss-Markov: rotation and mean are independent; the origin depends on both.
    const double variance = *residual.noiseMm * *residual.noiseMm;
    const Matrix3d rotation = variance * inertia.inverse();
    const Matrix3d lever = crossed(frame.linear() * middle);
    residual.angleRad = largestDeviation(rotation);
    residual.placeMm = largestDeviation(variance / static_cast<double>(n) * Matrix3d::Identity() +
                                        lever * rotation * lever.transpose());
  }
  return measured;
}

MeasuredTip toolTip(const std::vector<Eigen::Isometry3d>& base_T_flange) {
  constexpr double kSame = 1e-6, kMinRotation = 0.02;
  const std::size_t n = base_T_flange.size();
  if (n < 4)
    throw unusable("a tool tip needs at least four poses"_text, "measure another pose"_text);
  for (std::size_t i = 0; i < n; ++i) {
    requireFinite(base_T_flange[i].matrix().allFinite());
    for (std::size_t k = 0; k < i; ++k)
      if (base_T_flange[i].isApprox(base_T_flange[k], kSame))
        throw unusable(base::message("poses {first} and {second} are identical"_text, k + 1, i + 1),
                       "rotate the flange between poses"_text);
  }
  Matrix3d meanRotation = Matrix3d::Zero();
  Vector3d meanPlace = Vector3d::Zero();
  for (const Eigen::Isometry3d& pose : base_T_flange) {
    meanRotation += pose.linear() / static_cast<double>(n);
    meanPlace += pose.translation() / static_cast<double>(n);
  }
  // With the point eliminated: (R_i - mean R) tip = mean p - p_i.
  Eigen::MatrixX3d a(3 * static_cast<Eigen::Index>(n), 3);
  Eigen::VectorXd b(a.rows());
  for (std::size_t i = 0; i < n; ++i) {
    a.middleRows<3>(3 * static_cast<Eigen::Index>(i)) = base_T_flange[i].linear() - meanRotation;
    b.segment<3>(3 * static_cast<Eigen::Index>(i)) = meanPlace - base_T_flange[i].translation();
  }
  const geometry::SingularLeastSquares solved = geometry::leastSquaresBySingularValues(a, b);
  if (solved.singularValues[2] / std::sqrt(static_cast<double>(n)) < kMinRotation)
    throw unusable("the poses rotate the flange about one axis only, or hardly at all"_text,
                   "tilt it by at least 30 degrees about two axes"_text);
  MeasuredTip measured;
  measured.tipInFlange = solved.x;
  measured.pointInBase = meanRotation * measured.tipInFlange + meanPlace;
  std::vector<Vector3d> errors;
  for (const Eigen::Isometry3d& pose : base_T_flange)
    errors.push_back(pose * measured.tipInFlange - measured.pointInBase);
  Residual& residual = measured.residual;
  residual = residualOf(errors, 6);
  if (residual.noiseMm) {
    residual.placeMm = *residual.noiseMm / solved.singularValues[2];
    residual.angleRad = 0.0;
  }
  return measured;
}

} // namespace voluta::robot
