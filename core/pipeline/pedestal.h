// The pedestal that a part stands on with platform fit, as files for whoever makes it.
#pragma once

#include "geometry/triangle_mesh.h"
#include "pipeline/plan_result.h"
#include "plan/program.h"

#include <vector>

namespace voluta::pipeline {

// pedestal.dxf (its outline seen from above, a closed polyline of AutoCAD R12, mm; on a layer FOOT
// the foot's, where it lies beside what carries it: robot/plate.h) and pedestal.stl (the solid).
// Both in the work frame: the origin is where the cell carries it, z = 0 its top. None where the
// platform is not made for the part, or not known yet.
std::vector<plan::ProgramFile> pedestalFiles(const PlanResult& plan);

// How far the cell's platform lies beside what carries it, so that it would float, mm. 0: it is
// carried; as a pedestal is that is made beneath the part, which has a foot as far as its stem.
// A part that stands beside its place has none. `part`: placed.
double adriftMm(const project::Platform& platform, const geometry::TriangleMesh& part,
                const robot::Cell& cell);

} // namespace voluta::pipeline
