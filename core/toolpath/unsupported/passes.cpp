#include "toolpath/unsupported/passes.h"

#include "base/error.h"
#include "base/run_context.h"
#include "collision/growing_part.h"
#include "toolpath/stitching/add_shots.h"
#include "toolpath/unsupported/bridges.h"
#include "toolpath/unsupported/inset_walls.h"
#include "toolpath/unsupported/order_inside_out.h"
#include "toolpath/unsupported/rim_supports.h"
#include "toolpath/unsupported/slow_bridges.h"
#include "toolpath/unsupported/thicken_unsupported.h"
#include "toolpath/unsupported/tilt_unsupported.h"

#include <algorithm>
#include <array>
#include <utility>

namespace voluta::toolpath {

namespace {

constexpr std::array kPasses{
    UnsupportedPass{"thicken", PassPhase::BeforeDirections, PassChange::Waypoints,
                    thickenUnsupported},
    UnsupportedPass{"rimSupports", PassPhase::BeforeDirections, PassChange::Supports,
                    addRimSupports},
    UnsupportedPass{"insideOut", PassPhase::BeforeDirections, PassChange::Order, orderInsideOut},
    UnsupportedPass{"insetWalls", PassPhase::WithDirections, PassChange::Waypoints,
                    insetUnsupportedWalls},
    UnsupportedPass{"tilt", PassPhase::WithDirections, PassChange::Waypoints, tiltUnsupportedBeads},
    UnsupportedPass{"slowBridges", PassPhase::AfterDirections, PassChange::Waypoints, slowBridges},
};

bool isPlate(const platform::PlatformSolid& platform) {
  return platform.polygon.size() >= 3 && !platform.mesh && !platform.rod;
}

} // namespace

std::span<const UnsupportedPass> unsupportedPasses() {
  return kPasses;
}

UnsupportedBeads unsupportedBeads(PassPhase phase, const plan::ToolPlan& plan,
                                  std::vector<Eigen::Vector3d> clearDirection,
                                  const collision::GrowingPart& part,
                                  const platform::PlatformSolid& platform,
                                  const base::RunContext& ctx) {
  const bool withDirections = phase == PassPhase::WithDirections;
  UnsupportedBeads beads{
      plan,
      unsupportedWaypoints(plan, part, platform, ctx, withDirections ? kMinSupportedSamples : 1),
      std::move(clearDirection),
      {}};
  // Beads inside the part span the gaps of its infill: they are slowed down, never supported.
  if (phase != PassPhase::AfterDirections)
    for (const plan::ToolPath& path : plan.paths)
      if (plan::spansInterior(path.kind))
        std::fill_n(beads.unsupported.begin() + static_cast<std::ptrdiff_t>(path.first), path.count,
                    char{0});
  if (withDirections)
    for (std::size_t i = 0; i < plan.waypointCount(); ++i)
      beads.middle.emplace_back(plan.position[i] - 0.5 * plan.heightMm[i] * plan.direction[i]);
  return beads;
}

PassedPlan runUnsupportedPasses(PassPhase phase, const plan::ToolPlan& plan,
                                std::vector<Eigen::Vector3d> clearDirection,
                                std::shared_ptr<const collision::GrowingPart> grown,
                                const PassScene& scene, const base::RunContext& ctx) {
  const bool before = phase == PassPhase::BeforeDirections;
  base::require(clearDirection.size() == (before ? plan.waypointCount() : 0),
                "one clear direction per waypoint");
  PassedPlan out;
  if (plan.paths.empty() || (before && !isPlate(scene.platform))) {
    out.beads = {plan, std::vector<char>(plan.waypointCount(), 0), std::move(clearDirection), {}};
    out.grown = std::move(grown);
    return out;
  }
  if (!grown) {
    const double pitch = collision::growingPitch(plan, scene.tooling);
    grown = std::make_shared<const collision::GrowingPart>(
        plan, pitch, ctx, collision::groundCells(scene.platform, plan, pitch, ctx));
  }
  out.beads = unsupportedBeads(phase, plan, std::move(clearDirection), *grown, scene.platform, ctx);
  acceptBeadsOnPockets(plan, scene.pockets, out.beads.unsupported);
  std::shared_ptr<const collision::GrowingPart> seen = grown;
  const auto regrow = [&] {
    return collision::regrown(out.beads.plan, *grown, plan, scene.tooling, ctx);
  };
  bool isSeen = true; // the plan's latest change
  const SeenPart part = [&]() -> const collision::GrowingPart& {
    if (!std::exchange(isSeen, true))
      seen = regrow();
    return *seen;
  };
  for (const UnsupportedPass& pass : unsupportedPasses()) {
    if (pass.phase != phase ||
        std::ranges::find(out.beads.unsupported, 1) == out.beads.unsupported.end())
      continue;
    std::optional<PassResult> made = pass.run(out.beads, part, scene, ctx);
    if (!made)
      continue;
    out.beads = std::move(made->beads);
    out.isChanged = true;
    isSeen = before;
    out.addedMm3 += made->addedMm3;
    if (made->finding)
      out.findings.push_back(std::move(*made->finding));
    if (made->findingOfDirections)
      out.findingsOfDirections.push_back(std::move(made->findingOfDirections));
  }
  if (before && out.isChanged)
    out.grown = regrow();
  else if (phase != PassPhase::WithDirections)
    out.grown = std::move(grown);
  return out;
}

} // namespace voluta::toolpath
