// Exports tool-paths for visualisation in other programs (VTK's XML format for polygons).
#pragma once

#include "plan/tool_plan.h"

#include <string>

namespace voluta::toolpath {

// Returns the bytes of toolpath.vtp: one polyline per path; point data `width`, `height` (mm),
// `speed` (mm/s), `direction`; cell data `layer`, `patch`, `group`, `kind` (plan::PathKind).
// Written by base/vtk_xml.h.
std::string writeToolpathVtp(const plan::ToolPlan& plan);

} // namespace voluta::toolpath
