// A bead on a patch: a polyline with a cross-section at each point.
#pragma once

#include "plan/tool_plan.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::toolpath {

struct BeadPoint {
  Eigen::Vector3d middle;         // Centre of the bead's cross-section, on the patch's surface [mm]
  Eigen::Vector3d direction;      // Unit vector; nozzle direction of the patch
  Eigen::Vector3d clearDirection; // Unit vector; clear direction of the patch
  double widthMm = 0.0, heightMm = 0.0;
};
// A closed bead repeats its first point at its end.
struct Bead {
  std::vector<BeadPoint> points;
  plan::PathKind kind = plan::PathKind::Wall;
  int ring = 0; // Walls: 0 is the outermost
  bool closed = false;
  int tool = -1; // index in the job's tooling; negative: that of the patch
};

} // namespace voluta::toolpath
