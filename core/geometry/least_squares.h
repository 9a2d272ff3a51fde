// Least-squares solution of overdetermined linear equations, compiled once.
#pragma once

#include <Eigen/Core>

namespace voluta::geometry {

struct LeastSquares {
  Eigen::VectorXd x;     // minimizes |rows x - right|
  Eigen::Index rank = 0; // of the rows; if less than their columns, x is one of many solutions
};

// Solves by a rank-revealing QR decomposition (Householder, column pivoting). Precondition: one
// value per row.
LeastSquares leastSquares(const Eigen::MatrixXd& rows, const Eigen::VectorXd& right);

// Returns the shortest of the vectors that minimize |rows x - right|, also for fewer rows than
// columns. Precondition: one value per row, 6 at most.
Eigen::VectorXd
shortestLeastSquares(const Eigen::MatrixXd& rows,
                     const Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>& right);

} // namespace voluta::geometry
