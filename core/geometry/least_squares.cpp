#include "geometry/least_squares.h"

#include "base/error.h"

#include <Eigen/QR>

namespace voluta::geometry {

LeastSquares leastSquares(const Eigen::MatrixXd& rows, const Eigen::VectorXd& right) {
  base::require(rows.rows() == right.size(), "leastSquares: a value a row");
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(rows);
  return {solver.solve(right), solver.rank()};
}

} // namespace voluta::geometry
