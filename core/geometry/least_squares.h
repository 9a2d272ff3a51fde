// Overdetermined linear equations, compiled once.
#pragma once

#include <Eigen/Core>

namespace voluta::geometry {

struct LeastSquares {
  Eigen::VectorXd x;     // where |rows x - right| is least
  Eigen::Index rank = 0; // of the rows; less than their columns: x is one of many
};

// By a rank-revealing QR decomposition (Householder, columns pivoted). Precondition: as many values
// as rows.
LeastSquares leastSquares(const Eigen::MatrixXd& rows, const Eigen::VectorXd& right);

} // namespace voluta::geometry
