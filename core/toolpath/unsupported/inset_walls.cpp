#include "toolpath/unsupported/inset_walls.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "collision/growing_part.h"
#include "platform/platform_solid.h"
#include "toolpath/unsupported/bridges.h"
#include "toolpath/unsupported/lateral_taper.h"

#include <algorithm>

namespace voluta::toolpath {

namespace {

using Eigen::Vector3d;

constexpr double kStep = 0.0625; // beads
constexpr double kMax = 0.5;     // beads
constexpr double kSlope = 0.25;  // mm per mm along the path

class Drawer {
public:
  Drawer(const plan::ToolPlan& plan, const collision::GrowingPart& part,
         const platform::PlatformSolid& platform, const process::Tooling& tooling)
      : plan_(plan), part_(part), platform_(platform), tooling_(tooling) {}

  // Sets the moves of a path's waypoints.
  void draw(const plan::ToolPath& path, const std::vector<char>& unsupported,
            std::vector<Vector3d>& moves) const {
    for (const UnsupportedStretch& stretch :
         unsupportedStretches(plan_, path, unsupported, 0.5 * tooling_.of(path).process.bridgeMm))
      draw(path, stretch, moves);
  }

private:
  // Returns the smallest offset to that side (-1, 1) at which enough of the bead is supported; 0 if
  // there is none.
  double minOffset(const plan::ToolPath& path, std::size_t i, int side) const {
    const int steps = static_cast<int>(kMax / kStep);
    for (int k = 1; k <= steps; ++k) {
      const double offset = k * kStep * tooling_.of(path).process.beadWidthMm;
      const Vector3d tip = plan_.position[i] + side * offset * sideOf(plan_, path, i);
      if (supportedSamples(plan_, path, i, tip, plan_.direction[i], part_, platform_,
                           kMinSupportedSamples) >= kMinSupportedSamples)
        return offset;
    }
    return 0.0;
  }

  void draw(const plan::ToolPath& path, const UnsupportedStretch& s,
            std::vector<Vector3d>& moves) const {
    const LateralOffset draw =
        betterSide(s, [&](std::size_t i, int side) { return minOffset(path, i, side); });
    if (draw.side == 0)
      return;
    taperAlongPath(plan_, path, s, draw.amounts, kSlope, [&](std::size_t i, double mm) {
      const Vector3d move = draw.side * mm * sideOf(plan_, path, i);
      if (move.squaredNorm() > moves[i].squaredNorm())
        moves[i] = move;
    });
    if (path.closed) { // first and last waypoint are the same place
      Vector3d &first = moves[path.first], &last = moves[path.first + path.count - 1];
      first = last = first.squaredNorm() > last.squaredNorm() ? first : last;
    }
  }

  const plan::ToolPlan& plan_;
  const collision::GrowingPart& part_;
  const platform::PlatformSolid& platform_;
  const process::Tooling tooling_;
};

} // namespace

std::optional<PassResult> insetUnsupportedWalls(const UnsupportedBeads& beads, const SeenPart& part,
                                                const PassScene& scene,
                                                const base::RunContext& ctx) {
  const plan::ToolPlan& plan = beads.plan;
  base::require(beads.unsupported.size() == plan.waypointCount() &&
                    beads.middle.size() == plan.waypointCount(),
                "a mark and a middle for each waypoint");
  std::vector<Vector3d> moves(plan.waypointCount(), Vector3d::Zero());
  const Drawer drawer(plan, part(), scene.platform, scene.tooling);
  base::parallelChunks(ctx, plan.paths.size(), 1, [&](std::size_t b, std::size_t e) {
    for (std::size_t p = b; p < e && !ctx.cancelled(); ++p)
      if (plan.paths[p].kind == plan::PathKind::Wall)
        drawer.draw(plan.paths[p], beads.unsupported, moves);
  });
  ctx.checkpoint();
  if (std::ranges::all_of(moves, [](const Vector3d& move) { return move.isZero(); }))
    return std::nullopt;
  PassResult out{beads};
  for (std::size_t i = 0; i < moves.size(); ++i) {
    out.beads.plan.position[i] += moves[i];
    out.beads.middle[i] += moves[i];
    out.beads.unsupported[i] = beads.unsupported[i] && moves[i].isZero();
  }
  return out;
}

} // namespace voluta::toolpath
