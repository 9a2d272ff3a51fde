#include "motion/ladder/divided_step.h"

#include "base/error.h"
#include "motion/external_axes.h"
#include "motion/motion_options.h"

#include <utility>

namespace voluta::motion {

bool appendDivided(const MotionScene& scene, const RunPoint& to, int n,
                   std::vector<RunPoint>& points) {
  base::require(!points.empty() && n >= 1, "appendDivided: a way of at least one step");
  const RobotState from = points.back().at;
  std::vector<robot::JointVector> scratch;
  robot::JointVector q = from.q;
  for (int k = 1; k <= n; ++k) {
    const double t = static_cast<double>(k) / n;
    RunPoint p = to;
    p.volumeMm3 /= n;
    if (k < n) {
      p.waypoint = plan::kNoWaypoint;
      p.at.tip = from.tip + t * (to.at.tip - from.tip);
      p.at.tool = from.tool.slerp(t, to.at.tool);
      p.at.axes = from.axes + t * (to.at.axes - from.axes);
    }
    const robot::JointVector last = withAxes(scene.cell, q, p.at.axes);
    if (!solveNear(scene.cell, p.at.tip, p.at.tool, last, scene.options.maxStepRad, scratch, q))
      return false;
    p.at.q = q;
    points.push_back(std::move(p));
  }
  return true;
}

} // namespace voluta::motion
