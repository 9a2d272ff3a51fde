// Cuts lines to an area of a plane and joins their ends along its edge.
#pragma once

#include "base/run_context.h"
#include "geometry/polygon_paths.h"
#include "toolpath/plane/field_lines.h"

#include <vector>

namespace voluta::toolpath {

struct LineJoints {
  double insetMm = 0.0;    // of the lines' joined ends, and of the joints, from the area's edge
  double overlapMm = 0.0;  // by which free ends reach beyond the edge
  double shortestMm = 0.0; // shorter lines are left out
  double longestMm = 0.0;  // longest joint
  double totalMm = 0.0;    // of all joints: the shortest are made first
};

// Returns the lines inside the area. Ends that follow each other along the area's edge, inset, are
// joined along it; every joint is made between two lines that no other joint connects. Throws
// Cancelled.
std::vector<PlaneLine> joinedLines(const std::vector<PlaneLine>& lines,
                                   const ClipperLib::Paths& area, const LineJoints& joints,
                                   const base::RunContext& ctx);

} // namespace voluta::toolpath
