// Passes over unsupported beads, on plans of straight beads.
#pragma once

#include "base/run_context.h"
#include "collision/growing_part.h"
#include "robot/cell.h"
#include "straight_beads.h"
#include "toolpath/unsupported/passes.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::test {

inline const toolpath::UnsupportedPass& passOf(std::string_view id) {
  for (const toolpath::UnsupportedPass& pass : toolpath::unsupportedPasses())
    if (pass.id == id)
      return pass;
  throw std::invalid_argument("no such pass");
}

inline toolpath::PassScene sceneOn(const platform::PlatformSolid& platform,
                                   const process::Tooling& tooling = process::Tooling(kProcess)) {
  static const robot::Cell cell = robot::loadCell("ur5-fixed", kProcess, kPlate.polygon);
  return {cell, tooling, platform};
}

inline std::vector<Eigen::Vector3d> upwards(toolpath::PassPhase phase, const plan::ToolPlan& plan) {
  const bool before = phase == toolpath::PassPhase::BeforeDirections;
  return std::vector<Eigen::Vector3d>(before ? plan.waypointCount() : 0, Eigen::Vector3d::UnitZ());
}

// The input of one pass, as if it were the first of its phase, and its part.
struct PassInput {
  PassInput(const toolpath::UnsupportedPass& pass, const plan::ToolPlan& plan,
            const platform::PlatformSolid& platform)
      : part(plan, collision::growingPitch(plan, process::Tooling(kProcess)), {},
             collision::groundCells(platform, plan,
                                    collision::growingPitch(plan, process::Tooling(kProcess)), {})),
        beads(toolpath::unsupportedBeads(pass.phase, plan, upwards(pass.phase, plan), part,
                                         platform, {})) {}

  collision::GrowingPart part;
  toolpath::UnsupportedBeads beads;
};

inline std::optional<toolpath::PassResult> resultOf(const toolpath::UnsupportedPass& pass,
                                                    const PassInput& input,
                                                    const platform::PlatformSolid& platform,
                                                    const base::RunContext& ctx = {}) {
  const toolpath::SeenPart part = [&]() -> const collision::GrowingPart& { return input.part; };
  return pass.run(input.beads, part, sceneOn(platform), ctx);
}

// The beads after one pass, changed or not.
inline toolpath::UnsupportedBeads afterPass(std::string_view id, const plan::ToolPlan& plan,
                                            const platform::PlatformSolid& platform = kPlate) {
  const PassInput input(passOf(id), plan, platform);
  auto result = resultOf(passOf(id), input, platform);
  return result ? std::move(result->beads) : input.beads;
}

// The plan after all passes of a phase.
inline toolpath::PassedPlan afterPhase(toolpath::PassPhase phase, const plan::ToolPlan& plan,
                                       const platform::PlatformSolid& platform = kPlate) {
  return toolpath::runUnsupportedPasses(phase, plan, upwards(phase, plan), nullptr,
                                        sceneOn(platform), {});
}

} // namespace voluta::test
