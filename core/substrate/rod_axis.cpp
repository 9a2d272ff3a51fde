#include "substrate/rod_axis.h"

#include "base/error.h"
#include "geometry/least_squares.h"
#include "geometry/least_turn.h"
#include "geometry/measures.h"
#include "geometry/symmetric_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace voluta::substrate {

namespace {

constexpr double kClear = 1.5;

std::pair<Eigen::Vector3d, double> centreOfArea(const geometry::TriangleMesh& mesh) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double a = geometry::triangleArea(mesh, t);
    centre += a / 3.0 * (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2));
    area += a;
  }
  if (!(area > 0.0))
    throw base::Error(base::ErrorCode::UnusableInput, "the part has no surface"_text, "axis"_text);
  return {centre / area, area};
}

} // namespace

AxisFit axisAlong(const geometry::TriangleMesh& mesh, const Eigen::Vector3d& direction) {
  base::require(direction.norm() > 0.0, "a direction");
  AxisFit fit;
  fit.direction = direction.normalized();
  const auto [centre, area] = centreOfArea(mesh);
  // n . (a x (q - p)) = t . (q - p) with t = n x a.
  Eigen::Matrix3d left = fit.direction * fit.direction.transpose() * area;
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d side = geometry::triangleNormal(mesh, t).cross(fit.direction);
    const Eigen::Vector3d q =
        (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0 - centre;
    const Eigen::Matrix3d weighted = geometry::triangleArea(mesh, t) * side * side.transpose();
    left += weighted;
    right += weighted * q;
  }
  fit.point = centre + geometry::leastSquares(left, right).x;
  return fit;
}

AxisFit fitAxis(const geometry::TriangleMesh& mesh) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double a = geometry::triangleArea(mesh, t);
    const Eigen::Vector3d n = geometry::triangleNormal(mesh, t);
    spread += a * n * n.transpose();
  }
  const geometry::SymmetricAxes3 found = geometry::symmetricAxes(spread);
  const Eigen::Vector3d values = found.values.cwiseMax(0.0);
  const auto clearer = [&](int than, int by) {
    return values[than] > 0.0 ? values[by] / values[than] : std::numeric_limits<double>::infinity();
  };
  // The normals of a short part (a disc) are mostly along its axis.
  const bool isDisc = clearer(0, 1) < kClear;
  const double sharpness = isDisc ? clearer(1, 2) : clearer(0, 1);
  if (!(sharpness >= kClear) || values[1] <= 0.0)
    throw base::Error(base::ErrorCode::UnusableInput,
                      "the part has no clear axis: its surface normals have no preferred "
                      "direction"_text,
                      "axis"_text,
                      "set its axis (`rodAxis`), or rotate the part onto the rod manually"_text);
  Eigen::Vector3d direction = found.axes.col(isDisc ? 2 : 0);
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  if (direction[largest] < 0.0)
    direction = -direction;
  AxisFit fit = axisAlong(mesh, direction);
  fit.sharpness = sharpness;
  return fit;
}

geometry::Placement placementOnAxis(const geometry::TriangleMesh& mesh, double scale,
                                    const AxisFit& axis) {
  geometry::Placement placement;
  placement.rotation = geometry::shortestRotation(axis.direction, Eigen::Vector3d::UnitX());
  Eigen::AlignedBox3d box;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      box.extend(scale * (placement.rotation * mesh.corner(t, k)));
  const Eigen::Vector3d on = scale * (placement.rotation * axis.point);
  placement.centreMm = {0.0, box.center().y() - on.y()};
  placement.liftMm = box.min().z() - on.z();
  return placement;
}

} // namespace voluta::substrate
