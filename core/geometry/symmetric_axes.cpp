#include "geometry/symmetric_axes.h"

#include <Eigen/Eigenvalues>

namespace voluta::geometry {

SymmetricAxes3 symmetricAxes(const Eigen::Matrix3d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

SymmetricAxes2 symmetricAxes(const Eigen::Matrix2d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

SymmetricAxes3 symmetricAxesFast(const Eigen::Matrix3d& matrix) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

UpTo6 symmetricValues(const UpTo6x6& matrix) {
  return Eigen::SelfAdjointEigenSolver<UpTo6x6>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

} // namespace voluta::geometry
