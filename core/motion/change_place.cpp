#include "motion/change_place.h"

#include "base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace voluta::motion {

namespace {
using Eigen::Vector3d;

constexpr double kSpareMm = 30.0;
constexpr int kSteps = 18; // to each side
const double kStepRad = base::degreesToRadians(10.0);

// Returns whether a drop from that point, in that direction, meets the box.
bool dropMeets(const Vector3d& from, const Vector3d& down, const Eigen::AlignedBox3d& box) {
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    if (down[k] == 0.0) {
      if (from[k] < box.min()[k] || from[k] > box.max()[k])
        return false;
      continue;
    }
    const double a = (box.min()[k] - from[k]) / down[k], b = (box.max()[k] - from[k]) / down[k];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}
} // namespace

robot::JointVector changePlace(const MotionScene& scene, const robot::JointVector& home) {
  const robot::JointLimits& first = scene.cell.limits().front();
  if (first.kind == robot::JointKind::Sliding || scene.plan.position.empty())
    return home;
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : scene.plan.position)
    box.extend(p);
  box.min().array() -= kSpareMm;
  box.max().array() += kSpareMm;
  collision::CellCollision::Frames frames;
  for (int step = 0; step <= kSteps; ++step)
    for (const int side : {1, -1}) {
      robot::JointVector q = home;
      q[0] += side * step * kStepRad;
      if (q[0] < first.min || q[0] > first.max)
        continue;
      const Vector3d tip = scene.cell.work_T_tool(q).translation(),
                     down = scene.cell.base_T_work(q).linear().transpose() * -Vector3d::UnitZ();
      if (dropMeets(tip, down, box))
        continue;
      scene.cell.framePoses(q, frames);
      if (!scene.collision.bodies(frames, scene.options.travelling))
        return q;
    }
  return home;
}

} // namespace voluta::motion
