// Straight beads over a plate, as a plan.
#pragma once

#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/process.h"

#include <cmath>
#include <cstdlib>

namespace voluta::test {

inline const process::Process kProcess = process::loadProcess("fdm-1.0");
inline const platform::PlatformSolid kPlate{
    Eigen::Vector2d(-20, -20), {20, -20}, {20, 20}, {-20, 20}};

// A straight bead along x at y, tips at z, a waypoint a millimetre; a layer and a patch of its own
// number.
inline void addPath(plan::ToolPlan& plan, double fromX, double toX, double y, double z, int layer,
                    float height = 0.8f) {
  plan::ToolPath path;
  path.first = plan.waypointCount();
  path.patch = path.layer = layer;
  const int steps = static_cast<int>(std::ceil(std::abs(toX - fromX)));
  for (int k = 0; k <= steps; ++k) {
    plan.position.emplace_back(fromX + (toX - fromX) * k / steps, y, z);
    plan.direction.emplace_back(Eigen::Vector3d::UnitZ());
    plan.widthMm.push_back(1.2f);
    plan.heightMm.push_back(height);
    plan.speedMmPerS.push_back(20.0f);
  }
  path.count = plan.waypointCount() - path.first;
  plan.paths.push_back(path);
}

} // namespace voluta::test
