#include "substrate/touch_fit.h"

#include "base/error.h"
#include "geometry/least_squares.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

namespace voluta::substrate {

namespace {

// Minimum ratio of the shorter to the longer extent; less is a line.
constexpr double kLine = 1e-7;

[[noreturn]] void refuse(const base::Message& what) {
  throw base::Error(base::ErrorCode::UnusableInput, what, "touched points"_text,
                    "touch points farther apart around the cylinder"_text);
}

} // namespace

CircleFit circleThrough(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3)
    refuse(base::message("{points} points do not define a circle: at least three are needed"_text,
                         points.size()));
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixX2d centred(n, 2);
  for (Eigen::Index i = 0; i < n; ++i)
    centred.row(i) = points[static_cast<std::size_t>(i)];
  if (!centred.allFinite())
    refuse("a point has NaN or infinite coordinates"_text);
  const Eigen::Vector2d mean = centred.colwise().mean();
  centred.rowwise() -= mean.transpose();
  // Singular values, from the eigenvalues of the product matrix.
  const Eigen::Matrix2d products = centred.transpose() * centred;
  const double middle = 0.5 * products.trace(),
               apart = std::hypot(0.5 * (products(0, 0) - products(1, 1)), products(0, 1));
  const Eigen::Vector2d extent(std::sqrt(middle + apart), std::sqrt(std::max(0.0, middle - apart)));
  if (extent[1] <= kLine * extent[0])
    refuse("the points are collinear"_text);
  // Scale by the extent, so that the three columns have similar magnitude.
  const double unit = extent[0];
  centred /= unit;
  Eigen::MatrixX3d rows(n, 3);
  rows << centred, Eigen::VectorXd::Ones(n);
  const Eigen::VectorXd right = -centred.rowwise().squaredNorm();
  const Eigen::Vector3d abc = geometry::leastSquares(rows, right).x;
  CircleFit fit;
  const Eigen::Vector2d centre = -0.5 * abc.head<2>();
  fit.centre = mean + unit * centre;
  fit.radiusMm = unit * std::sqrt(centre.squaredNorm() - abc[2]);
  double squares = 0.0;
  for (const Eigen::Vector2d& p : points)
    squares += std::pow((p - fit.centre).norm() - fit.radiusMm, 2);
  fit.rmsMm = std::sqrt(squares / static_cast<double>(n));
  return fit;
}

} // namespace voluta::substrate
