#include "toolpath/stitching/add_shots.h"

#include "base/units.h"
#include "plan/waypoints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;
using plan::PathKind;

// Height of the nozzle above a pocket, and speeds into and out of it (Castelli, table 6.1).
constexpr double kAboveMm = 2.0, kDownMmPerS = 10.0, kUpMmPerS = 50.0;

using Pockets = std::vector<const layers::Pocket*>;

// Returns the pockets by the path that each follows.
std::map<std::size_t, Pockets> pocketsBehindPaths(const plan::ToolPlan& plan,
                                                  std::span<const layers::Pocket> pockets) {
  std::map<std::pair<int, int>, std::size_t> lastOf; // by item and layer
  for (std::size_t k = 0; k < plan.paths.size(); ++k)
    if (!plan::isWaste(plan.paths[k].kind))
      lastOf[{plan.paths[k].item, plan.paths[k].layer}] = k;
  std::map<std::size_t, Pockets> behind;
  for (const layers::Pocket& pocket : pockets)
    if (const auto last = lastOf.find({pocket.item, pocket.layer}); last != lastOf.end())
      behind[last->second].push_back(&pocket);
  return behind;
}

// Appends copies of a path's waypoints and the path.
void copyPath(plan::ToolPlan& to, const plan::ToolPlan& from, const plan::ToolPath& path) {
  plan::ToolPath copy = path;
  copy.first = to.waypointCount();
  for (std::size_t w = path.first; w < path.first + path.count; ++w)
    plan::appendWaypoint(to, from, w);
  to.paths.push_back(copy);
}

void addShot(plan::ToolPlan& plan, const layers::Pocket& pocket, const plan::ToolPath& after,
             const process::Process& process, const StitchOptions& options) {
  plan.paths.push_back({.first = plan.waypointCount(),
                        .count = 3,
                        .kind = PathKind::Shot,
                        .layer = pocket.layer,
                        .patch = after.patch,
                        .group = after.group,
                        .item = pocket.item,
                        .tool = pocket.tool});
  const double depth = std::min(options.depthMm, pocket.depthMm);
  const double height = pocket.depthMm - depth, mm3 = (1.0 + options.excess) * pocket.volumeMm3,
               width = std::sqrt(4.0 * mm3 / (base::kPi * std::max(height, 1e-3)));
  for (const double above : {kAboveMm, -depth, kAboveMm}) {
    plan.position.push_back(pocket.top + above * pocket.direction);
    plan.direction.push_back(pocket.direction);
    plan.widthMm.push_back(static_cast<float>(width));
    plan.heightMm.push_back(static_cast<float>(height));
    plan.speedMmPerS.push_back(static_cast<float>(
        std::min(process.travelSpeedMmPerS, above < kAboveMm ? kDownMmPerS : kUpMmPerS)));
  }
}

} // namespace

void addShots(plan::ToolPlan& plan, std::span<const layers::Pocket> pockets,
              const process::Tooling& tooling, const StitchOptions& options) {
  if (pockets.empty())
    return;
  const plan::ToolPlan before = std::move(plan);
  std::map<std::size_t, Pockets> behind = pocketsBehindPaths(before, pockets);
  plan = {};
  plan.fill = before.fill;
  for (std::size_t k = 0; k < before.paths.size(); ++k) {
    copyPath(plan, before, before.paths[k]);
    Pockets& left = behind[k];
    while (!left.empty()) {
      const Vector3d from = plan.position.back();
      const auto nearest = std::ranges::min_element(left, {}, [&](const layers::Pocket* pocket) {
        return (pocket->top - from).squaredNorm();
      });
      addShot(plan, **nearest, before.paths[k], tooling.at((*nearest)->tool).process, options);
      left.erase(nearest);
    }
  }
}

void acceptBeadsOnPockets(const plan::ToolPlan& plan, std::span<const layers::Pocket> pockets,
                          std::vector<char>& unsupported) {
  if (pockets.empty())
    return;
  for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
    if (!unsupported[i])
      continue;
    const auto height = static_cast<double>(plan.heightMm[i]);
    const Vector3d under = plan.position[i] - height * plan.direction[i];
    unsupported[i] = std::ranges::none_of(pockets, [&](const layers::Pocket& pocket) {
      const Vector3d step = under - pocket.top;
      const double up = step.dot(pocket.direction), lateral = (step - up * pocket.direction).norm();
      return std::abs(up) < 0.5 * height &&
             lateral < 0.5 * (pocket.openingMm + static_cast<double>(plan.widthMm[i]));
    });
  }
}

} // namespace voluta::toolpath
