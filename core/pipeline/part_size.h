// Is the part of a size that can be printed, and its walls of a bead's?
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "motion/too_large.h"
#include "plan/finding.h"
#include "process/process.h"

#include <functional>
#include <optional>

namespace voluta::pipeline {

// A part shorter than a millimetre or longer than two metres was drawn in other units: nothing can
// be planned for it. Else what of it is thinner than the process's least bead, where that is more
// than may be left out (plan::kBlockingShare); it blocks where beads would stand over, or what they
// leave out would miss, more of the part than a replay lets pass. `reach`: the scale up to which
// the part is in reach; it takes half a second, and is asked for only where walls are thin. Throws
// Cancelled.
plan::Findings sizeFindings(const geometry::TriangleMesh& part, double scale,
                            const std::function<double()>& reach, const process::Process& process,
                            const base::RunContext& ctx);

// A scale to offer: to three digits, downwards, as more than `most` would leave the part too large.
double scaleWithin(double most);

// That the robot gets to too little of a part that stands at `scale`, and the scale at which it
// would get to it; nullopt: the part has no other.
plan::Finding tooLargeFinding(const motion::TooLarge& told, std::optional<double> scale);

} // namespace voluta::pipeline
