#include "toolpath/unsupported/tilt_unsupported.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "plan/finding_kinds.h"
#include "platform/platform_solid.h"
#include "toolpath/unsupported/lateral_taper.h"
#include "toolpath/unsupported/tiltable_stretches.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::toolpath {

namespace {

using Eigen::Vector3d;

constexpr double kStepDeg = 10.0, kMaxDeg = 50.0;
constexpr double kFadeDegPerMm = 5.0; // smooths noise between waypoints caused by the cells

// Returns the direction tilted sideways to the path by an angle.
Vector3d leaning(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t i,
                 double deg) {
  const double rad = base::degreesToRadians(deg);
  return std::cos(rad) * plan.direction[i] + std::sin(rad) * sideOf(plan, path, i);
}

class Bracer {
public:
  Bracer(const plan::ToolPlan& plan, const collision::GrowingPart& part,
         const platform::PlatformSolid& platform)
      : plan_(plan), part_(part), platform_(platform) {}

  // Tilts a stretch's waypoints, and those before and after it while the tilt fades.
  void brace(const plan::ToolPath& path, const UnsupportedStretch& s,
             std::vector<Vector3d>& directions) const {
    const LateralOffset lean =
        betterSide(s, [&](std::size_t i, int side) { return minTiltDeg(path, i, side); });
    if (lean.side == 0)
      return;
    taperAlongPath(plan_, path, s, lean.amounts, kFadeDegPerMm, [&](std::size_t i, double deg) {
      const Vector3d d = leaning(plan_, path, i, lean.side * deg);
      if (d.dot(plan_.direction[i]) < directions[i].dot(plan_.direction[i]))
        directions[i] = d;
    });
    if (path.closed) { // first and last waypoint are the same place
      Vector3d &first = directions[path.first], &last = directions[path.first + path.count - 1];
      const Vector3d& own = plan_.direction[path.first];
      first = last = first.dot(own) < last.dot(own) ? first : last;
    }
  }

private:
  // Returns the smallest tilt to that side (-1, 1) at which enough of the bead is supported,
  // otherwise the one with most support; 0 if no tilt gives any.
  double minTiltDeg(const plan::ToolPath& path, std::size_t i, int side) const {
    const double half = 0.5 * static_cast<double>(plan_.heightMm[i]);
    const Vector3d middle = plan_.position[i] - half * plan_.direction[i];
    double best = 0.0;
    int maximum = 0;
    for (double deg = kStepDeg; deg <= kMaxDeg && maximum < kMinSupportedSamples; deg += kStepDeg) {
      const Vector3d d = leaning(plan_, path, i, side * deg);
      const int places = supportedSamples(plan_, path, i, middle + half * d, d, part_, platform_,
                                          kMinSupportedSamples);
      if (places > maximum) {
        maximum = places;
        best = deg;
      }
    }
    return best;
  }

  const plan::ToolPlan& plan_;
  const collision::GrowingPart& part_;
  const platform::PlatformSolid& platform_;
};

// Returns whether there is any stretch to be tilted.
bool canTilt(const UnsupportedBeads& beads, const process::Tooling& tooling) {
  return !isUpright(beads.plan) &&
         std::ranges::any_of(beads.plan.paths, [&](const plan::ToolPath& path) {
           return !tiltableStretches(beads.plan, path, beads.unsupported, tooling).empty();
         });
}

// Returns the finding about those of the tilted waypoints (ascending) whose chosen direction is
// not that of their layer; nullopt if there are none.
std::optional<plan::Finding> braced(const std::vector<std::size_t>& tilted,
                                    const plan::ToolPlan& begun,
                                    const std::vector<Vector3d>& direction) {
  std::size_t paths = 0;
  double minCosine = 1.0;
  Vector3d where = Vector3d::Zero();
  auto next = tilted.begin();
  for (const plan::ToolPath& path : begun.paths) {
    bool any = false;
    for (; next != tilted.end() && *next < path.first + path.count; ++next) {
      const Vector3d& own = begun.direction[*next];
      if (direction[*next] == own)
        continue;
      if (paths == 0 && !any)
        where = begun.position[*next];
      any = true;
      minCosine = std::min(minCosine, own.dot(direction[*next]));
    }
    paths += any ? 1 : 0;
  }
  if (paths == 0)
    return std::nullopt;
  return plan::makeFinding(
      plan::FindingKind::Braced,
      {{"paths", paths}, {"lean", base::degrees(base::radiansToDegrees(std::acos(minCosine)))}},
      where, paths);
}

} // namespace

std::optional<PassResult> tiltUnsupportedBeads(const UnsupportedBeads& beads, const SeenPart& part,
                                               const PassScene& scene,
                                               const base::RunContext& ctx) {
  const plan::ToolPlan& plan = beads.plan;
  base::require(beads.unsupported.size() == plan.waypointCount() &&
                    beads.middle.size() == plan.waypointCount(),
                "a mark and a middle for each waypoint");
  ctx.checkpoint();
  if (!scene.canTilt || !canTilt(beads, scene.tooling))
    return std::nullopt;
  std::vector<Vector3d> directions = plan.direction;
  const Bracer bracer(plan, part(), scene.platform);
  base::parallelChunks(ctx, plan.paths.size(), 1, [&](std::size_t b, std::size_t e) {
    for (std::size_t p = b; p < e && !ctx.cancelled(); ++p)
      for (const UnsupportedStretch& s :
           tiltableStretches(plan, plan.paths[p], beads.unsupported, scene.tooling))
        bracer.brace(plan.paths[p], s, directions);
  });
  ctx.checkpoint();
  PassResult out{beads};
  std::vector<std::size_t> tilted;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (directions[i] == plan.direction[i])
      continue;
    out.beads.plan.direction[i] = directions[i];
    out.beads.plan.position[i] =
        beads.middle[i] + 0.5 * static_cast<double>(plan.heightMm[i]) * directions[i];
    out.beads.unsupported[i] = 0;
    tilted.push_back(i);
  }
  if (tilted.empty())
    return std::nullopt;
  out.findingOfDirections = [tilted = std::move(tilted)](const plan::ToolPlan& begun,
                                                         const std::vector<Vector3d>& direction) {
    return braced(tilted, begun, direction);
  };
  return out;
}

} // namespace voluta::toolpath
