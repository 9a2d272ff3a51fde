#include "voxel/triangle_box.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace voluta::voxel {

TriangleBoxTest::TriangleBoxTest(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& c, double halfWidth) {
  const auto add = [&](const Eigen::Vector3d& axis) {
    if (axis.squaredNorm() == 0.0)
      return;
    const double pa = axis.dot(a), pb = axis.dot(b), pc = axis.dot(c);
    const double reach = halfWidth * axis.cwiseAbs().sum();
    slabs_[count_++] = {axis, std::min({pa, pb, pc}) - reach, std::max({pa, pb, pc}) + reach};
  };
  for (int i = 0; i < 3; ++i)
    add(Eigen::Vector3d::Unit(i));
  const Eigen::Vector3d edges[3] = {b - a, c - b, a - c};
  add(edges[0].cross(edges[1]));
  for (const Eigen::Vector3d& edge : edges)
    for (int i = 0; i < 3; ++i)
      add(edge.cross(Eigen::Vector3d::Unit(i)));
}

bool TriangleBoxTest::overlaps(const Eigen::Vector3d& centre) const {
  for (int i = 0; i < count_; ++i) {
    const double p = slabs_[i].axis.dot(centre);
    if (p <= slabs_[i].low || p >= slabs_[i].high)
      return false;
  }
  return true;
}

} // namespace voluta::voxel
