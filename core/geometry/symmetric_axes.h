// Eigenvalues and eigenvectors of symmetric matrices, each solver compiled once.
#pragma once

#include <Eigen/Core>

namespace voluta::geometry {

// Eigenvalues of a symmetric matrix in ascending order; the columns of `axes` are the orthonormal
// eigenvectors in the same order, with arbitrary signs. Only the lower triangle is read.
struct SymmetricAxes3 {
  Eigen::Vector3d values;
  Eigen::Matrix3d axes;
};
struct SymmetricAxes2 {
  Eigen::Vector2d values;
  Eigen::Matrix2d axes;
};
SymmetricAxes3 symmetricAxes(const Eigen::Matrix3d& matrix);
SymmetricAxes2 symmetricAxes(const Eigen::Matrix2d& matrix);
// The same by the closed form, which is faster and less accurate.
SymmetricAxes3 symmetricAxesFast(const Eigen::Matrix3d& matrix);

// Eigenvalues of a symmetric matrix of up to 6 rows, ascending.
using UpTo6x6 = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
using UpTo6 = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;
UpTo6 symmetricValues(const UpTo6x6& matrix);

} // namespace voluta::geometry
