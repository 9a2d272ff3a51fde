// The parameter `orient`: rotates a part before it is planned.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "geometry/placement.h"
#include "geometry/triangle_mesh.h"
#include "modes/cut_estimate.h"
#include "modes/from_options.h"
#include "placement/orient.h"
#include "plan/finding.h"
#include "project/choices.h"

#include <functional>
#include <optional>
#include <string>

namespace voluta::pipeline {

struct TurnedPart {
  geometry::Placement placement; // the given placement, rotated further
  plan::Findings findings; // the improvement found, or that there is none; none of them blocks
  double seconds = 0.0;
};

// Parameters of the search for an orientation.
struct OrientationPlan {
  std::string objective; // value of the parameter orient; "none": keep the orientation
  double voxelMm = 0.0;  // voxel width for growing the part
  double overhangRad = 0.0;
  project::Platform platform;                    // on which missed voxels are counted
  std::optional<modes::CutEstimateOptions> cuts; // of leastAfterCuts
};
// If no search is required, the values that only a search uses are left at zero.
OrientationPlan orientationPlan(const modes::ModeChoices& in);

// Returns what the cuts of a mode that makes pieces leave of the part placed like that; nullopt if
// it cannot be cut.
using CheckedCuts =
    std::function<std::optional<placement::CutOutcome>(const geometry::Placement& placement)>;

// Searches for the orientation. `placed`: the part placed by `placement`. `voxelMm`: replaces the
// plan's voxel width. `onlyQuarters`: only quarter turns, which keep the part's own cells. Without
// a search the placement is returned unchanged. `checkedCuts`: empty if the mode makes no pieces.
// `tension`: of leastTension, in the frame of `placed`; empty for others. Throws as
// placement::bestOrientation(); Cancelled.
TurnedPart turnedPart(const geometry::TriangleMesh& placed, const geometry::Placement& placement,
                      const OrientationPlan& plan, double voxelMm, bool onlyQuarters,
                      const CheckedCuts& checkedCuts, const placement::TensionOf& tension,
                      const base::RunContext& ctx);

} // namespace voluta::pipeline
