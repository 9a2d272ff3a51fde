// Building blocks of the made parts: dice that roll the same everywhere, and solids.
#pragma once

#include "geometry/mesh_boolean.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace voluta::test {

// std's distributions are not the same everywhere.
class Dice {
public:
  explicit Dice(unsigned seed) : state_(0x9e3779b97f4a7c15u * (seed + 1)) {}
  double between(double low, double high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  int among(int low, int high) { return low + static_cast<int>(between(0.0, high - low + 1.0)); }

private:
  std::uint64_t state_;
};

// Union and difference. Precondition: the solids are closed.
geometry::TriangleMesh operator+(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b);
geometry::TriangleMesh operator-(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b);

geometry::TriangleMesh moved(geometry::TriangleMesh mesh, const Eigen::Isometry3d& to);
// A closed polygon of (radius, z), radius > 0, turned about z.
geometry::TriangleMesh turned(std::vector<Eigen::Vector2d> section, int sides);
// A round rod along a line of points, its ends flat.
geometry::TriangleMesh swept(const std::vector<Eigen::Vector3d>& line,
                             const std::vector<double>& radius, int sides = 28);
geometry::TriangleMesh cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                double radius);

} // namespace voluta::test
