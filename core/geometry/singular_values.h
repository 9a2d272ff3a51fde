// Singular value decompositions, compiled once.
#pragma once

#include <Eigen/Core>

namespace voluta::geometry {

// Singular values, descending.
Eigen::VectorXd singularValues(const Eigen::MatrixXd& matrix);
Eigen::Vector3d singularValues(const Eigen::Matrix3Xd& matrix);

// Orthogonal u and v of the decomposition u * diagonal * v'.
struct SingularVectors {
  Eigen::Matrix3d u, v;
};
SingularVectors singularVectors(const Eigen::Matrix3d& matrix);

// `x` minimizes |rows x - right|; `singularValues`: of the rows, descending. Preconditions: one
// value per row; at least as many rows as columns.
struct SingularLeastSquares {
  Eigen::VectorXd x, singularValues;
};
SingularLeastSquares leastSquaresBySingularValues(const Eigen::MatrixXd& rows,
                                                  const Eigen::VectorXd& right);

} // namespace voluta::geometry
