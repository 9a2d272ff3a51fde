// Isolines of a field that is defined modulo one: lines that wind around a surface.
#pragma once

#include "base/run_context.h"
#include "toolpath/patch_surface.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::toolpath {

// A linear field of a chart's coordinates that numbers the lines: u * perU + v * perV + offset.
struct Winding {
  double perU = 0.0, perV = 0.0; // lines per mm
  double offset = 0.0;

  double at(const Eigen::Vector2d& uv) const { return uv.x() * perU + uv.y() * perV + offset; }
};

// Returns the curves where the field is an integer plus one half; larger values are to the left,
// seen against the triangles' normals. The curves cross the chart's seam like any other edge: a
// helix is a single curve. Deterministic order. Preconditions: the surface has a chart; perU *
// periodMm is an integer. Throws Cancelled.
std::vector<SurfaceCurve> periodicIsolines(const PatchSurface& surface, const Winding& winding,
                                           const base::RunContext& ctx = {});

} // namespace voluta::toolpath
