// The choice `orient`: a part is turned before it is planned.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "geometry/placement.h"
#include "geometry/triangle_mesh.h"
#include "plan/finding.h"
#include "project/job.h"

#include <string>

namespace voluta::pipeline {

struct TurnedPart {
  geometry::Placement placement; // the chosen one, turned further
  plan::Findings findings;       // what was won, or that nothing was; none of them blocks
  double seconds = 0.0;
};

// `placed`: the part where choices.placement puts it. `voxelMm`: width of the voxels it will be
// grown on. `onlyQuarters`: only turns that keep its own cells. Without orient the placement stays.
// Throws as placement::bestOrientation(); Cancelled.
TurnedPart turnedPart(const geometry::TriangleMesh& placed, const project::Choices& choices,
                      const base::ParameterValues& values, double voxelMm, bool onlyQuarters,
                      const base::RunContext& ctx);

// What `orient` adds to the key of the Load stage; empty for none.
std::string turnText(const project::Choices& choices, const base::ParameterValues& values);

} // namespace voluta::pipeline
