#include "geometry/least_squares.h"

#include "base/error.h"

#include <Eigen/QR>

namespace voluta::geometry {

LeastSquares leastSquares(const Eigen::MatrixXd& rows, const Eigen::VectorXd& right) {
  base::require(rows.rows() == right.size(), "leastSquares: a value a row");
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(rows);
  return {solver.solve(right), solver.rank()};
}

Eigen::VectorXd
shortestLeastSquares(const Eigen::MatrixXd& rows,
                     const Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>& right) {
  base::require(rows.rows() == right.size(), "shortestLeastSquares: a value a row");
  return rows.completeOrthogonalDecomposition().solve(right);
}

} // namespace voluta::geometry
