#include "replay/joint_arcs.h"

#include "geometry/directions.h"

#include <algorithm>

namespace voluta::replay {

namespace {
constexpr int kSamples = 256;
constexpr double kSameMm = 0.25, kSameRad = 0.02;
} // namespace

void JointArcs::sample(std::size_t point) {
  if (sampled_ == point)
    return;
  sampled_ = point;
  tip_.clear();
  direction_.clear();
  const Eigen::Map<const Eigen::VectorXd> from(trajectory_.at(point - 1), cell_.dof()),
      to(trajectory_.at(point), cell_.dof());
  for (int k = 0; k <= kSamples; ++k) {
    const robot::JointVector q = from + (to - from) * (static_cast<double>(k) / kSamples);
    const Eigen::Isometry3d work_T_tool = cell_.work_T_tool(q);
    tip_.push_back(work_T_tool.translation());
    direction_.push_back(-work_T_tool.linear().col(2));
  }
}

bool JointArcs::passes(std::size_t point, const Eigen::Vector3d& tip,
                       const Eigen::Vector3d& direction) {
  if (point == 0 || point >= trajectory_.pointCount() ||
      trajectory_.move[point] != plan::MoveKind::Joint)
    return false;
  sample(point);
  for (std::size_t k = 1; k < tip_.size(); ++k) {
    const Eigen::Vector3d step = tip_[k] - tip_[k - 1];
    const double squared = step.squaredNorm();
    const double t =
        squared > 0.0 ? std::clamp(step.dot(tip - tip_[k - 1]) / squared, 0.0, 1.0) : 1.0;
    if ((tip_[k - 1] + t * step - tip).norm() <= kSameMm &&
        (!directions_ || geometry::angleBetween((1.0 - t) * direction_[k - 1] + t * direction_[k],
                                                direction) <= kSameRad))
      return true;
  }
  return false;
}

} // namespace voluta::replay
