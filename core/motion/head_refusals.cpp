#include "motion/head_refusals.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "motion/motion_options.h"
#include "motion/nozzle_frame.h"
#include "plan/tool_plan.h"

#include <cmath>

namespace voluta::motion {

namespace {

constexpr std::size_t kChunk = 256;
constexpr double kSlackMm = 1e-6;

// Returns whether a direction deviates from the only one of a cell that cannot tilt the nozzle.
bool leans(const Eigen::Vector3d& direction) {
  return std::hypot(direction.x(), direction.y()) > robot::kUprightFlangeRad ||
         direction.z() <= 0.0;
}

bool beyondRod(const robot::CellRod& rod, const Eigen::Vector3d& tip) {
  return tip.tail<2>().norm() > rod.printableRadiusMm + kSlackMm ||
         std::abs(tip.x()) > 0.5 * rod.lengthMm + kSlackMm;
}

} // namespace

std::vector<std::size_t> headBefore(const plan::ToolPlan& plan) {
  std::vector<std::size_t> before(plan.waypointCount());
  for (const plan::ToolPath& path : plan.paths) {
    std::size_t tail = path.first;
    double distance = 0.0; // Distance from the tail to here
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      if (i > path.first)
        distance += (plan.position[i] - plan.position[i - 1]).norm();
      while (tail < i) {
        const double step = (plan.position[tail + 1] - plan.position[tail]).norm();
        if (distance - step < 2.0 * static_cast<double>(plan.widthMm[i]))
          break;
        distance -= step;
        ++tail;
      }
      before[i] = tail;
    }
  }
  return before;
}

std::vector<Refusal> headRefusals(const MotionScene& scene, const std::vector<std::size_t>& before,
                                  const base::RunContext& ctx) {
  const plan::ToolPlan& plan = scene.plan;
  std::vector<Refusal> refusals(plan.waypointCount(), Refusal::None);
  base::parallelChunks(ctx, plan.waypointCount(), kChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t i = b; i < e; ++i) {
      if (scene.cell.rod() && beyondRod(*scene.cell.rod(), plan.position[i])) {
        refusals[i] = Refusal::BeyondRod;
        continue;
      }
      if (!scene.cell.tilts() && leans(plan.direction[i])) {
        refusals[i] = Refusal::Leans;
        continue;
      }
      const Eigen::Isometry3d pose =
          toolPose(plan.position[i], carried(uprightTool(), plan.direction[i]));
      const double margin = scene.options.printing.headMm;
      if (scene.collision.headTouchesPart(pose, scene.part, before[i], margin, i))
        refusals[i] = Refusal::HeadPart;
      else if (scene.collision.headTouchesPlatform(pose, margin))
        refusals[i] = Refusal::HeadPlatform;
    }
  });
  return refusals;
}

} // namespace voluta::motion
