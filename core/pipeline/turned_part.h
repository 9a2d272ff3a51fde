// The choice `orient`: a part is turned before it is planned.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "geometry/placement.h"
#include "geometry/triangle_mesh.h"
#include "plan/finding.h"
#include "project/choices.h"

#include <string>

namespace voluta::pipeline {

struct TurnedPart {
  geometry::Placement placement; // the chosen one, turned further
  plan::Findings findings;       // what was won, or that nothing was; none of them blocks
  double seconds = 0.0;
};

// How a way to lie is searched for.
struct TurnPlan {
  std::string objective; // of the parameter orient; "none": as it lies
  double voxelMm = 0.0;  // width of the voxels it will be grown on
  double overhangRad = 0.0;
  project::Platform platform; // where voxels are missed
};
// Without what a search that is not asked for would take.
TurnPlan turnPlan(const project::Choices& choices, const base::ParameterValues& values);

// `placed`: the part where `placement` puts it. `voxelMm`: instead of the plan's. `onlyQuarters`:
// only turns that keep its own cells. Without a search the placement stays. Throws as
// placement::bestOrientation(); Cancelled.
TurnedPart turnedPart(const geometry::TriangleMesh& placed, const geometry::Placement& placement,
                      const TurnPlan& plan, double voxelMm, bool onlyQuarters,
                      const base::RunContext& ctx);

} // namespace voluta::pipeline
