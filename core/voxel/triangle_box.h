// Whether a triangle and a cube meet.
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

  // Whether the closed triangle meets the open cube about `centre`.
  bool overlaps(const Eigen::Vector3d& centre) const;

private:
  struct Slab {
    Eigen::Vector3d axis;
    double low, high; // of axis . centre where the cube meets the triangle along this axis
  };
  Slab slabs_[13];
  int count_ = 0;
};

} // namespace voluta::voxel
