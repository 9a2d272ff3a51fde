#include "toolpath/braced.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "base/units.h"
#include "toolpath/fading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace voluta::toolpath {

namespace {

using Eigen::Vector3d;

constexpr double kStepDeg = 10.0, kMostDeg = 50.0;
constexpr double kFadeDegPerMm = 5.0; // cells tell one waypoint from the next by chance

// But for supports, which lean where the head would cut in, and may be left out.
bool isUpright(const plan::ToolPlan& plan) {
  return std::ranges::all_of(plan.paths, [&](const plan::ToolPath& path) {
    const auto first = plan.direction.begin() + static_cast<std::ptrdiff_t>(path.first);
    return path.kind == plan::PathKind::Support ||
           std::all_of(first, first + static_cast<std::ptrdiff_t>(path.count),
                       [](const Vector3d& d) { return d == Vector3d::UnitZ(); });
  });
}

// Those of a path that come last and lean.
std::vector<HangingStretch> stretchesOf(const plan::ToolPlan& plan, const plan::ToolPath& path,
                                        const std::vector<char>& hanging,
                                        const process::Process& process) {
  if (path.kind == plan::PathKind::Support)
    return {};
  return hangingStretches(plan, path, hanging, 0.5 * process.bridgeMm);
}

// To the side of the way, by an angle.
Vector3d leaning(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t i,
                 double deg) {
  const double rad = base::degreesToRadians(deg);
  return std::cos(rad) * plan.direction[i] + std::sin(rad) * sideOf(plan, path, i);
}

// Squared distance of the furthest of what hangs from the nearest waypoint that does not.
double outwardsMm2(const plan::ToolPlan& plan, const std::vector<HangingStretch>& stretches,
                   const std::vector<Vector3d>& carried) {
  double furthest = 0.0;
  for (const HangingStretch& s : stretches)
    for (std::size_t i = s.begin; i < s.end; ++i) {
      double nearest = std::numeric_limits<double>::max();
      for (const Vector3d& at : carried)
        nearest = std::min(nearest, (plan.position[i] - at).squaredNorm());
      furthest = std::max(furthest, nearest);
    }
  return furthest;
}

class Bracer {
public:
  Bracer(const plan::ToolPlan& plan, const collision::GrowingPart& part,
         const platform::PlatformSolid& platform)
      : plan_(plan), part_(part), platform_(platform) {}

  // Of a stretch's waypoints and what leads to and from it.
  void brace(const plan::ToolPath& path, const HangingStretch& s,
             std::vector<Vector3d>& directions) const {
    const Aside lean =
        betterSide(s, [&](std::size_t i, int side) { return leastDeg(path, i, side); });
    if (lean.side == 0)
      return;
    fadeAlong(plan_, path, s, lean.amounts, kFadeDegPerMm, [&](std::size_t i, double deg) {
      const Vector3d d = leaning(plan_, path, i, lean.side * deg);
      if (d.dot(plan_.direction[i]) < directions[i].dot(plan_.direction[i]))
        directions[i] = d;
    });
    if (path.closed) { // the same place twice
      Vector3d &first = directions[path.first], &last = directions[path.first + path.count - 1];
      const Vector3d& own = plan_.direction[path.first];
      first = last = first.dot(own) < last.dot(own) ? first : last;
    }
  }

private:
  // The least lean to that side (-1, 1) at which enough of the bead is carried, or else most of it;
  // 0: none of it ever is.
  double leastDeg(const plan::ToolPath& path, std::size_t i, int side) const {
    const double half = 0.5 * static_cast<double>(plan_.heightMm[i]);
    const Vector3d middle = plan_.position[i] - half * plan_.direction[i];
    double best = 0.0;
    int most = 0;
    for (double deg = kStepDeg; deg <= kMostDeg && most < kWellCarried; deg += kStepDeg) {
      const Vector3d d = leaning(plan_, path, i, side * deg);
      const int places =
          carriedPlaces(plan_, path, i, middle + half * d, d, part_, platform_, kWellCarried);
      if (places > most) {
        most = places;
        best = deg;
      }
    }
    return best;
  }

  const plan::ToolPlan& plan_;
  const collision::GrowingPart& part_;
  const platform::PlatformSolid& platform_;
};

} // namespace

std::vector<std::size_t> inwardsFirst(const plan::ToolPlan& plan, const std::vector<char>& hanging,
                                      const process::Process& process) {
  base::require(hanging.size() == plan.waypointCount(), "a mark for each waypoint");
  std::vector<std::size_t> order(plan.paths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (isUpright(plan))
    return order;
  for (std::size_t b = 0; b < order.size();) {
    std::size_t e = b + 1;
    while (e < order.size() && plan.paths[e].patch == plan.paths[b].patch &&
           plan.paths[e - 1].kind != plan::PathKind::Skirt)
      ++e;
    std::vector<std::size_t> first;
    std::vector<std::pair<std::size_t, std::vector<HangingStretch>>> outer;
    for (std::size_t p = b; p < e; ++p) {
      std::vector<HangingStretch> stretches = stretchesOf(plan, plan.paths[p], hanging, process);
      if (stretches.empty())
        first.push_back(p);
      else
        outer.emplace_back(p, std::move(stretches));
    }
    std::vector<Vector3d> carried;
    if (!outer.empty())
      for (std::size_t p = b; p < e; ++p)
        for (std::size_t i = plan.paths[p].first; i < plan.paths[p].first + plan.paths[p].count;
             ++i)
          if (!hanging[i])
            carried.push_back(plan.position[i]);
    if (!carried.empty()) {
      std::vector<std::pair<double, std::size_t>> outwards;
      for (const auto& [path, stretches] : outer)
        outwards.emplace_back(outwardsMm2(plan, stretches, carried), path);
      std::ranges::sort(outwards);
      const auto rest =
          std::ranges::copy(first, order.begin() + static_cast<std::ptrdiff_t>(b)).out;
      std::ranges::transform(outwards, rest, [](const auto& o) { return o.second; });
    }
    b = e;
  }
  return order;
}

bool canBrace(const plan::ToolPlan& plan, const std::vector<char>& hanging,
              const process::Process& process) {
  base::require(hanging.size() == plan.waypointCount(), "a mark for each waypoint");
  return !isUpright(plan) && std::ranges::any_of(plan.paths, [&](const plan::ToolPath& path) {
    return !stretchesOf(plan, path, hanging, process).empty();
  });
}

std::vector<Vector3d> braced(const plan::ToolPlan& plan, const std::vector<char>& hanging,
                             const collision::GrowingPart& part,
                             const platform::PlatformSolid& platform,
                             const process::Process& process, const base::RunContext& ctx) {
  base::require(hanging.size() == plan.waypointCount(), "a mark for each waypoint");
  std::vector<Vector3d> directions = plan.direction;
  if (isUpright(plan))
    return directions;
  const Bracer bracer(plan, part, platform);
  base::parallelChunks(ctx, plan.paths.size(), 1, [&](std::size_t b, std::size_t e) {
    for (std::size_t p = b; p < e && !ctx.cancelled(); ++p)
      for (const HangingStretch& s : stretchesOf(plan, plan.paths[p], hanging, process))
        bracer.brace(plan.paths[p], s, directions);
  });
  ctx.checkpoint();
  return directions;
}

} // namespace voluta::toolpath
