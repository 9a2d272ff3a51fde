// Circles, cylinders and spheres through points of a mesh.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace voluta::geometry {

struct RoundShape {
  enum class Of { Edge, Cylinder, Sphere } of = Of::Edge;
  double radiusMm = 0.0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // of a cylinder: on its axis, beside the point
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();   // unit; zero: of a sphere
};

// Returns whether the point is on the shape, as far as a mesh file's rounding goes: 5 um and 0.02 %
// of the radius.
bool isOn(const RoundShape& shape, const Eigen::Vector3d& point);
// Returns whether the corners are on the cylinder or sphere and the normal is its normal beside
// them: a facet of another face may have its corners near by. `normal`: unit, of the facet.
bool isFacetOf(const RoundShape& shape, const std::array<Eigen::Vector3d, 3>& corners,
               const Eigen::Vector3d& normal);

// None: the points are on a line.
std::optional<RoundShape> circleThrough(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                        const Eigen::Vector3d& c);
// These return the shape of least squares. None: points are off it (isOn()), or determine none.
std::optional<RoundShape> cylinderThrough(const std::vector<Eigen::Vector3d>& points,
                                          const Eigen::Vector3d& axis);
std::optional<RoundShape> sphereThrough(const std::vector<Eigen::Vector3d>& points);
// Returns the same kind of shape through more points; `shape` itself if it does not fit them
// better.
RoundShape refined(const RoundShape& shape, const std::vector<Eigen::Vector3d>& points);

} // namespace voluta::geometry
