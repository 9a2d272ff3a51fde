// A quick estimate of what cutting into pieces leaves of a part's overhang.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "modes/from_options.h"
#include "planar/pieces.h"
#include "process/process.h"

#include <cstddef>

namespace voluta::modes {

struct CutEstimateOptions {
  planar::RiskRule rule;
  process::HeadShape head;
};
CutEstimateOptions cutEstimateOptions(const ModeChoices& in);

struct CutEstimate {
  double riskyMm2 = 0.0; // of all pieces
  std::size_t pieces = 1;
};

// Number of triangles that a part needs for the estimate.
inline constexpr std::size_t kCutEstimateTriangles = 3000;

// Cuts the part by the greedy scheme, on a plate made for it, whatever scheme and plate the part is
// planned with. Precondition: `part` is on z = 0. Throws Error{UnusableInput} if it is not closed;
// Cancelled.
CutEstimate estimatedCuts(const geometry::TriangleMesh& part, const CutEstimateOptions& options,
                          const base::RunContext& ctx);

} // namespace voluta::modes
