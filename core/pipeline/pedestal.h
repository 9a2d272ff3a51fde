// The pedestal of a fitted platform (platform `fit`), as files for manufacturing it.
#pragma once

#include "geometry/triangle_mesh.h"
#include "pipeline/plan_result.h"
#include "plan/program.h"

#include <vector>

namespace voluta::pipeline {

// Returns pedestal.dxf (the outline in plan view, a closed polyline of AutoCAD R12 [mm]; layer FOOT
// has the foot's outline if the pedestal is offset from its carrier: robot/plate.h) and
// pedestal.stl (the solid). Both are in the work frame: the origin is where the cell carries the
// platform, z = 0 is its top. Returns no files if the platform is not made for the part or not
// known yet.
std::vector<plan::ProgramFile> pedestalFiles(const PlanResult& plan);

// Returns the gap between the cell's platform and its carrier, by which it would float [mm]. 0: the
// platform is carried. So is a pedestal made below the part, which has a foot that extends to its
// stem, unless the part is placed beside the platform's position. `part`: placed.
double adriftMm(const project::Platform& platform, const geometry::TriangleMesh& part,
                const robot::Cell& cell);

} // namespace voluta::pipeline
