// The part as it will be printed, for whoever wants to look at it: its outer beads as a mesh.
#pragma once

#include "collision/growing_part.h"
#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"

namespace voluta::pipeline {

// A tube along each stretch of segments of which something is seen from outside, eight corners
// around (of the area of the bead's section, process/bead_model.h), closed at both ends; waypoints
// that lie within 0.15 mm of the line between others are left out. Tubes lie in one another where
// beads do. Waste is none of it. `part` was grown from `plan`. mm.
geometry::TriangleMesh outerBeads(const plan::ToolPlan& plan, const collision::GrowingPart& part);

} // namespace voluta::pipeline
