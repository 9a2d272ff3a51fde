#include "toolpath/unsupported/tilt_unsupported.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "base/units.h"
#include "toolpath/unsupported/lateral_taper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace voluta::toolpath {

namespace {

using Eigen::Vector3d;

constexpr double kStepDeg = 10.0, kMostDeg = 50.0;
// in bead widths: maximum distance between the centrelines of neighbours
constexpr double kBesideWidths = 1.5;
constexpr double kFadeDegPerMm = 5.0; // smooths noise between waypoints caused by the cells

// Ignores supports, which tilt where the head would collide and can be left out.
bool isUpright(const plan::ToolPlan& plan) {
  return std::ranges::all_of(plan.paths, [&](const plan::ToolPath& path) {
    const auto first = plan.direction.begin() + static_cast<std::ptrdiff_t>(path.first);
    return path.kind == plan::PathKind::Support ||
           std::all_of(first, first + static_cast<std::ptrdiff_t>(path.count),
                       [](const Vector3d& d) { return d == Vector3d::UnitZ(); });
  });
}

// Returns the stretches of a path that have to be printed last and tilted.
std::vector<UnsupportedStretch> stretchesOf(const plan::ToolPlan& plan, const plan::ToolPath& path,
                                            const std::vector<char>& hanging,
                                            const process::Tooling& tooling) {
  if (path.kind == plan::PathKind::Support)
    return {};
  return hangingStretches(plan, path, hanging, 0.5 * tooling.of(path).process.bridgeMm);
}

// Returns the direction tilted sideways to the path by an angle.
Vector3d leaning(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t i,
                 double deg) {
  const double rad = base::degreesToRadians(deg);
  return std::cos(rad) * plan.direction[i] + std::sin(rad) * sideOf(plan, path, i);
}

// Squared distance of the unsupported waypoint furthest from all supported ones to the nearest of
// them.
double outwardsMm2(const plan::ToolPlan& plan, const std::vector<UnsupportedStretch>& stretches,
                   const std::vector<Vector3d>& carried) {
  double furthest = 0.0;
  for (const UnsupportedStretch& s : stretches)
    for (std::size_t i = s.begin; i < s.end; ++i) {
      double nearest = std::numeric_limits<double>::max();
      for (const Vector3d& at : carried)
        nearest = std::min(nearest, (plan.position[i] - at).squaredNorm());
      furthest = std::max(furthest, nearest);
    }
  return furthest;
}

// For an open path, returns whether more of its unsupported waypoints are beside lines that it
// prints later than beside lines already printed.
bool leansOnLater(const plan::ToolPlan& plan, const plan::ToolPath& path,
                  const std::vector<UnsupportedStretch>& stretches,
                  const std::vector<char>& hanging) {
  std::vector<double> along(path.count, 0.0); // mm from its start
  for (std::size_t k = 1; k < path.count; ++k)
    along[k] =
        along[k - 1] + (plan.position[path.first + k] - plan.position[path.first + k - 1]).norm();
  int later = 0;
  for (const UnsupportedStretch& s : stretches)
    for (std::size_t i = s.begin; i < s.end; ++i) {
      const double reach = kBesideWidths * static_cast<double>(plan.widthMm[i]);
      double nearest = reach * reach;
      int side = 0;
      for (std::size_t k = 0; k < path.count; ++k) {
        const std::size_t j = path.first + k;
        // Neighbouring waypoints along the path are not beside it.
        if (hanging[j] || std::abs(along[k] - along[i - path.first]) < 2.0 * reach)
          continue;
        if (const double d = (plan.position[j] - plan.position[i]).squaredNorm(); d < nearest) {
          nearest = d;
          side = j > i ? 1 : -1;
        }
      }
      later += side;
    }
  return later > 0;
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
        betterSide(s, [&](std::size_t i, int side) { return leastDeg(path, i, side); });
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
  double leastDeg(const plan::ToolPath& path, std::size_t i, int side) const {
    const double half = 0.5 * static_cast<double>(plan_.heightMm[i]);
    const Vector3d middle = plan_.position[i] - half * plan_.direction[i];
    double best = 0.0;
    int most = 0;
    for (double deg = kStepDeg; deg <= kMostDeg && most < kMinSupportedSamples; deg += kStepDeg) {
      const Vector3d d = leaning(plan_, path, i, side * deg);
      const int places = supportedSamples(plan_, path, i, middle + half * d, d, part_, platform_,
                                          kMinSupportedSamples);
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

std::vector<OrderedPath> orderInsideOut(const plan::ToolPlan& plan,
                                        const std::vector<char>& hanging,
                                        const process::Tooling& tooling) {
  base::require(hanging.size() == plan.waypointCount(), "a mark for each waypoint");
  std::vector<OrderedPath> order(plan.paths.size());
  for (std::size_t p = 0; p < order.size(); ++p)
    order[p].path = p;
  if (isUpright(plan))
    return order;
  for (std::size_t b = 0; b < order.size();) {
    std::size_t e = b + 1;
    while (e < order.size() && plan.paths[e].patch == plan.paths[b].patch &&
           !plan::isWaste(plan.paths[e - 1].kind))
      ++e;
    std::vector<std::size_t> first;
    std::vector<std::pair<std::size_t, std::vector<UnsupportedStretch>>> outer;
    for (std::size_t p = b; p < e; ++p) {
      std::vector<UnsupportedStretch> stretches =
          stretchesOf(plan, plan.paths[p], hanging, tooling);
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
      std::vector<std::pair<double, OrderedPath>> outwards;
      for (const auto& [p, stretches] : outer) {
        const plan::ToolPath& path = plan.paths[p];
        outwards.emplace_back(
            outwardsMm2(plan, stretches, carried),
            OrderedPath{p, !path.closed && leansOnLater(plan, path, stretches, hanging)});
      }
      std::ranges::stable_sort(outwards, {}, &std::pair<double, OrderedPath>::first);
      std::size_t at = b;
      for (const std::size_t p : first)
        order[at++] = {p};
      for (const auto& [distance, path] : outwards)
        order[at++] = path;
    }
    b = e;
  }
  return order;
}

bool canBrace(const plan::ToolPlan& plan, const std::vector<char>& hanging,
              const process::Tooling& tooling) {
  base::require(hanging.size() == plan.waypointCount(), "a mark for each waypoint");
  return !isUpright(plan) && std::ranges::any_of(plan.paths, [&](const plan::ToolPath& path) {
    return !stretchesOf(plan, path, hanging, tooling).empty();
  });
}

std::vector<Vector3d>
tiltUnsupportedBeads(const plan::ToolPlan& plan, const std::vector<char>& hanging,
                     const collision::GrowingPart& part, const platform::PlatformSolid& platform,
                     const process::Tooling& tooling, const base::RunContext& ctx) {
  base::require(hanging.size() == plan.waypointCount(), "a mark for each waypoint");
  std::vector<Vector3d> directions = plan.direction;
  if (isUpright(plan))
    return directions;
  const Bracer bracer(plan, part, platform);
  base::parallelChunks(ctx, plan.paths.size(), 1, [&](std::size_t b, std::size_t e) {
    for (std::size_t p = b; p < e && !ctx.cancelled(); ++p)
      for (const UnsupportedStretch& s : stretchesOf(plan, plan.paths[p], hanging, tooling))
        bracer.brace(plan.paths[p], s, directions);
  });
  ctx.checkpoint();
  return directions;
}

} // namespace voluta::toolpath
