// The passes over unsupported beads: a table with a row each, and the loop that runs them. A new
// pass is a file of its own and a row in passes.cpp.
//
// Widths of walls are chosen before there is a plan (supported_walls.h), so that is no pass.
#pragma once

#include "toolpath/unsupported/unsupported_pass.h"

#include <memory>
#include <span>
#include <vector>

namespace voluta::toolpath {

// Returns the table, in the order in which passes run.
std::span<const UnsupportedPass> unsupportedPasses();

// Returns the input of the first pass of a phase, with the judgement of all its passes:
// unsupportedWaypoints(), WithDirections with kMinSupportedSamples. `part`: of the plan.
// `clearDirection`: per waypoint, BeforeDirections only. Throws Cancelled.
UnsupportedBeads unsupportedBeads(PassPhase phase, const plan::ToolPlan& plan,
                                  std::vector<Eigen::Vector3d> clearDirection,
                                  const collision::GrowingPart& part,
                                  const platform::PlatformSolid& platform,
                                  const base::RunContext& ctx);

// A plan after all passes of a phase.
struct PassedPlan {
  UnsupportedBeads beads;
  bool isChanged = false;
  double addedMm3 = 0.0;
  plan::Findings findings;
  std::vector<FindingOfDirections> findingsOfDirections;
  // The beads of the plan at collision::growingPitch(). Null WithDirections, whose result is not
  // printed as it is, and where no part was given and there was nothing to do.
  std::shared_ptr<const collision::GrowingPart> grown = {};
};

// Runs the passes of a phase. `grown`: the beads of the plan at collision::growingPitch() with the
// platform as the ground; null: they are deposited here. Precondition: BeforeDirections, one clear
// direction per waypoint, otherwise none. Throws Cancelled.
PassedPlan runUnsupportedPasses(PassPhase phase, const plan::ToolPlan& plan,
                                std::vector<Eigen::Vector3d> clearDirection,
                                std::shared_ptr<const collision::GrowingPart> grown,
                                const PassScene& scene, const base::RunContext& ctx);

} // namespace voluta::toolpath
