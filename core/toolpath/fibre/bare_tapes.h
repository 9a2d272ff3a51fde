// Tape that no plastic covers.
#pragma once

#include "plan/tool_plan.h"

#include <Eigen/Core>

namespace voluta::toolpath {

struct BareTapes {
  double lengthMm = 0.0;
  int layer = 0; // of the first such place
  Eigen::Vector3d where = Eigen::Vector3d::Zero();
};

// Returns the length of tape without a later bead of its item directly above its middle and both
// its sides.
BareTapes bareTapes(const plan::ToolPlan& plan, double tapeWidthMm);

} // namespace voluta::toolpath
