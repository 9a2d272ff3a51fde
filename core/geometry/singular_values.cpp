#include "geometry/singular_values.h"

#include "base/error.h"

#include <Eigen/SVD>

namespace voluta::geometry {

Eigen::VectorXd singularValues(const Eigen::MatrixXd& matrix) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues();
}

Eigen::Vector3d singularValues(const Eigen::Matrix3Xd& matrix) {
  return Eigen::JacobiSVD<Eigen::Matrix3Xd>(matrix).singularValues();
}

SingularVectors singularVectors(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.matrixV()};
}

SingularLeastSquares leastSquaresBySingularValues(const Eigen::MatrixXd& rows,
                                                  const Eigen::VectorXd& right) {
  base::require(rows.rows() == right.size() && rows.rows() >= rows.cols(),
                "leastSquaresBySingularValues: a value a row, no fewer rows than columns");
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.solve(right), svd.singularValues()};
}

} // namespace voluta::geometry
