#include "robot/shape/shape_moves.h"

#include "base/error.h"

namespace voluta::robot {

Shape moved(Shape shape, const Eigen::Isometry3d& by) {
  if (auto* box = std::get_if<Box>(&shape)) {
    box->frame_T_box = by * box->frame_T_box;
  } else if (auto* capsule = std::get_if<Capsule>(&shape)) {
    capsule->p0 = by * capsule->p0;
    capsule->p1 = by * capsule->p1;
  } else {
    auto* frustum = std::get_if<Frustum>(&shape);
    base::require(frustum != nullptr, "a solid that can lie anyhow");
    frustum->p0 = by * frustum->p0;
    frustum->p1 = by * frustum->p1;
  }
  return shape;
}

} // namespace voluta::robot
