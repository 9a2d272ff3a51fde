// Writes a plan's beads as a 3MF package that other programs can print: the Toolpath Extension 1.0.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"

#include <string>

namespace voluta::base {
class RunContext;
}

namespace voluta::build3mf {

// NAME.build.3mf (Part I, chapter 3).
inline constexpr const char* kEnding = ".build.3mf";

// Returns the package as bytes: the part as the object to build, and every path of the plan, in
// order, as a segment "polyline6d" (Part II, 1.4.2). Equal inputs give equal bytes.
// - Coordinates are those of the work frame in units of 0.1 um (kUnitMm). A point's frame has its z
//   along the waypoint's direction, from the bead into the nozzle; its x is free, and rotates as
//   little as possible from the frame of the path's previous point.
// - One profile per kind of path; beadwidth and beadheight (linear modifiers) and depositionspeed
//   (constant) where they vary within it. Section and flow follow from them by
//   process/bead_model.h: flow = area x speed.
// - One layer part for each run of paths of one layer, in print order.
// - A closed path repeats its first point at the end: for 6 axes there are no loops.
//
// Preconditions (Error{Internal}): arrays of one length; widths, heights and speeds of printed
// beads > 0; paths as ToolPlan specifies; the part has triangles. Throws Error{CannotWrite} for
// coordinates beyond 200 m or more data than a package can hold; Cancelled.
std::string writeBuild(const plan::ToolPlan& plan, const geometry::TriangleMesh& part,
                       const std::string& name, const base::RunContext& ctx);

inline constexpr double kUnitMm = 1e-4;

} // namespace voluta::build3mf
