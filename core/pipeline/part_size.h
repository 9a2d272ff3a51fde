// Checks whether the part has a printable size and its walls are at least one bead wide.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "motion/too_large.h"
#include "plan/finding.h"
#include "process/process.h"

#include <functional>
#include <optional>

namespace voluta::pipeline {

// Returns a blocking finding for parts smaller than 1 mm or larger than 2 m: they were drawn in
// other units. Otherwise returns the share of the part that is thinner than the process's minimum
// bead width, if that exceeds plan::kBlockingShare. That finding blocks if most of the part is
// thinner: nothing of it would be printed as drawn, and planning takes time. `reach` returns the
// maximum scale within the robot's reach; it takes half a second and is called only if walls are
// thin. Throws Cancelled.
plan::Findings sizeFindings(const geometry::TriangleMesh& part, double scale,
                            const std::function<double()>& reach, const process::Process& process,
                            const base::RunContext& ctx);

// Returns `maximum` rounded down to three digits: rounding up would leave the part too large.
double scaleWithin(double maximum);

// Returns the finding that the robot reaches too little of a part of scale `scale`, with the scale
// at which it would reach enough. nullopt: no other scale can be offered.
plan::Finding tooLargeFinding(const motion::TooLarge& tooLarge, std::optional<double> scale);

} // namespace voluta::pipeline
