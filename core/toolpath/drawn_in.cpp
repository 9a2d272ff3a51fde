#include "toolpath/drawn_in.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "toolpath/bridges.h"

#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

namespace {

using Eigen::Vector3d;

constexpr int kCarried = 2;      // of the places across a bead: a quarter
constexpr double kStep = 0.0625; // beads
constexpr double kMost = 0.5;    // beads
constexpr double kSlope = 0.25;  // of the way along the path

class Drawer {
public:
  Drawer(const plan::ToolPlan& plan, const collision::GrowingPart& part,
         const platform::PlatformSolid& platform, const process::Process& process)
      : plan_(plan), part_(part), platform_(platform), process_(process) {}

  // Of the waypoints of a path.
  void draw(const plan::ToolPath& path, const std::vector<char>& hanging,
            std::vector<Vector3d>& moves) const {
    for (const HangingStretch& stretch :
         hangingStretches(plan_, path, hanging, 0.5 * process_.bridgeMm))
      draw(path, stretch, moves);
  }

private:
  // The least way to that side (-1, 1) at which enough of the bead is carried; 0: there is none.
  double least(const plan::ToolPath& path, std::size_t i, int side) const {
    const int steps = static_cast<int>(kMost / kStep);
    for (int k = 1; k <= steps; ++k) {
      const double aside = k * kStep * process_.beadWidthMm;
      if (carriedPlaces(plan_, path, i, side * aside, part_, platform_, kCarried) >= kCarried)
        return aside;
    }
    return 0.0;
  }

  void draw(const plan::ToolPath& path, const HangingStretch& s,
            std::vector<Vector3d>& moves) const {
    std::vector<double> best;
    std::size_t most = 0;
    int side = 0;
    for (const int to : {-1, 1}) {
      std::vector<double> aside(s.end - s.begin);
      for (std::size_t i = s.begin; i < s.end; ++i)
        aside[i - s.begin] = least(path, i, to);
      const auto carried = static_cast<std::size_t>(
          std::count_if(aside.begin(), aside.end(), [](double mm) { return mm > 0.0; }));
      if (carried > most) {
        most = carried;
        best = std::move(aside);
        side = to;
      }
    }
    if (most == 0)
      return;
    for (const bool forwards : {true, false}) {
      double mm = 0.0;
      std::size_t i = forwards ? s.begin : s.end - 1;
      for (std::size_t done = 0; done < path.count; ++done) {
        const bool inside = i >= s.begin && i < s.end;
        mm = std::max(inside ? best[i - s.begin] : 0.0, mm);
        if (mm <= 0.0 && !inside)
          break;
        const Vector3d move = side * mm * sideOf(plan_, path, i);
        if (move.squaredNorm() > moves[i].squaredNorm())
          moves[i] = move;
        const std::size_t next = neighbour(path, i, forwards);
        if (next == i)
          break;
        mm -= kSlope * (plan_.position[next] - plan_.position[i]).norm();
        i = next;
      }
    }
    if (path.closed) { // the same place twice
      Vector3d &first = moves[path.first], &last = moves[path.first + path.count - 1];
      first = last = first.squaredNorm() > last.squaredNorm() ? first : last;
    }
  }

  // Round a closed path; the same at the end of another.
  static std::size_t neighbour(const plan::ToolPath& path, std::size_t i, bool forwards) {
    const std::size_t last = path.first + path.count - 1;
    if (forwards)
      return i < last ? i + 1 : path.closed ? path.first + 1 : i;
    return i > path.first ? i - 1 : path.closed ? last - 1 : i;
  }

  const plan::ToolPlan& plan_;
  const collision::GrowingPart& part_;
  const platform::PlatformSolid& platform_;
  const process::Process& process_;
};

} // namespace

std::vector<Vector3d> drawnIn(const plan::ToolPlan& plan, const collision::GrowingPart& part,
                              const platform::PlatformSolid& platform,
                              const process::Process& process, const base::RunContext& ctx) {
  const std::vector<char> hanging = hangingWaypoints(plan, part, platform, ctx, kCarried);
  std::vector<Vector3d> moves(plan.waypointCount(), Vector3d::Zero());
  const Drawer drawer(plan, part, platform, process);
  base::parallelChunks(ctx, plan.paths.size(), 1, [&](std::size_t b, std::size_t e) {
    for (std::size_t p = b; p < e && !ctx.cancelled(); ++p)
      if (plan.paths[p].kind == plan::PathKind::Wall)
        drawer.draw(plan.paths[p], hanging, moves);
  });
  ctx.checkpoint();
  return moves;
}

} // namespace voluta::toolpath
