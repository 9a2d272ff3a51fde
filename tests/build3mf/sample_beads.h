// Plans of beads without a robot: random ones for round trips, rows of beads in closed form.
#pragma once

#include "helpers/shapes.h"
#include "plan/tool_plan.h"

#include <Eigen/Geometry>
#include <random>

namespace voluta::test {

// Paths of every kind, open and closed, on `layers` layers; directions anywhere on the sphere but
// not jumping.
inline plan::ToolPlan randomBeads(unsigned seed, int layers) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto point = [&] { return Eigen::Vector3d(unit(random), unit(random), unit(random)); };
  plan::ToolPlan plan;
  for (int layer = 0; layer < layers; ++layer)
    for (int p = 0; p < 4; ++p) {
      plan::ToolPath path;
      path.first = plan.waypointCount();
      path.kind = static_cast<plan::PathKind>((layer + p) % 6);
      path.layer = layer / 2;
      path.patch = p;
      path.group = layer % 3;
      path.closed = p == 1;
      Eigen::Vector3d at = 100.0 * point(), direction = point().normalized();
      const int count = 3 + static_cast<int>(random() % 20);
      for (int i = 0; i < count; ++i) {
        at += point() + Eigen::Vector3d(0.5, 0.0, 0.0);
        direction = (direction + 0.3 * point()).normalized();
        plan.position.push_back(at);
        plan.direction.push_back(direction);
        plan.widthMm.push_back(static_cast<float>(1.2 + 0.3 * unit(random)));
        plan.heightMm.push_back(static_cast<float>(0.8 + 0.2 * unit(random)));
        plan.speedMmPerS.push_back(static_cast<float>(20.0 + 10.0 * unit(random)));
      }
      if (path.closed) {
        plan.position.push_back(plan.position[path.first]);
        plan.direction.push_back(plan.direction[path.first]);
        plan.widthMm.push_back(plan.widthMm[path.first]);
        plan.heightMm.push_back(plan.heightMm[path.first]);
        plan.speedMmPerS.push_back(20.0f);
      }
      path.count = plan.waypointCount() - path.first;
      plan.paths.push_back(path);
    }
  return plan;
}

} // namespace voluta::test
