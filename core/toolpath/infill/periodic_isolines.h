// Lines that wind around: isolines of a field that is known modulo one.
#pragma once

#include "base/run_context.h"
#include "toolpath/patch_surface.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::toolpath {

// A linear field of a chart's coordinates that counts lines: u * perU + v * perV + offset.
struct Winding {
  double perU = 0.0, perV = 0.0; // lines a mm
  double offset = 0.0;

  double at(const Eigen::Vector2d& uv) const { return uv.x() * perU + uv.y() * perV + offset; }
};

// Curves where the field is a whole number and a half; larger values lie to the left, seen against
// the triangles' normals. They run over the chart's seam as over any other place: a helix is one
// curve from end to end. Deterministic order. Preconditions: the surface has a chart; perU *
// periodMm is a whole number. Throws Cancelled.
std::vector<SurfaceCurve> periodicIsolines(const PatchSurface& surface, const Winding& winding,
                                           const base::RunContext& ctx = {});

} // namespace voluta::toolpath
