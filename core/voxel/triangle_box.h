// Overlap test of a triangle and a cube.
#pragma once

#include <Eigen/Core>

namespace voluta::voxel {

// A triangle prepared for many cubes of one size: separating axes (Akenine-Moller, Fast 3D
// Triangle-Box Overlap Testing, JGT 2001).
class TriangleBoxTest {
public:
  // halfWidth > 0: half the edge of the cubes.
  TriangleBoxTest(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  double halfWidth);

  // Returns whether the closed triangle intersects the open cube about `centre`.
  bool overlaps(const Eigen::Vector3d& centre) const;

private:
  struct Slab {
    Eigen::Vector3d axis;
    // Bounds of axis . centre within which cube and triangle overlap along this axis
    double low, high;
  };
  Slab slabs_[13];
  int count_ = 0;
};

} // namespace voluta::voxel
