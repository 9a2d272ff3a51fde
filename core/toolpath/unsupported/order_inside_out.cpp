#include "toolpath/unsupported/order_inside_out.h"

#include "base/error.h"
#include "base/run_context.h"
#include "plan/waypoints.h"
#include "toolpath/unsupported/tiltable_stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace voluta::toolpath {

namespace {

using Eigen::Vector3d;

// in bead widths: maximum distance between the centrelines of neighbours
constexpr double kBesideWidths = 1.5;

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
                  const std::vector<char>& unsupported) {
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
        if (unsupported[j] || std::abs(along[k] - along[i - path.first]) < 2.0 * reach)
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

// Appends a path with its waypoints, marks and clear directions.
void appendPath(UnsupportedBeads& to, const UnsupportedBeads& from, const OrderedPath& next) {
  const plan::ToolPath& path = from.plan.paths[next.path];
  plan::ToolPath same = path;
  same.first = to.plan.waypointCount();
  for (std::size_t k = 0; k < path.count; ++k) {
    const std::size_t i = path.first + (next.turned ? path.count - 1 - k : k);
    plan::appendWaypoint(to.plan, from.plan, i);
    // A waypoint's speed is that of the segment leading to it.
    if (next.turned && k > 0)
      to.plan.speedMmPerS.back() = from.plan.speedMmPerS[i + 1];
    to.unsupported.push_back(from.unsupported[i]);
    to.clearDirection.push_back(from.clearDirection[i]);
  }
  to.plan.paths.push_back(same);
}

} // namespace

std::vector<OrderedPath> insideOutOrder(const plan::ToolPlan& plan,
                                        const std::vector<char>& unsupported,
                                        const process::Tooling& tooling) {
  base::require(unsupported.size() == plan.waypointCount(), "a mark for each waypoint");
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
          tiltableStretches(plan, plan.paths[p], unsupported, tooling);
      if (stretches.empty())
        first.push_back(p);
      else
        outer.emplace_back(p, std::move(stretches));
    }
    std::vector<Vector3d> carried;
    if (!outer.empty())
      for (std::size_t p = b; p < e; ++p) {
        const plan::ToolPath& path = plan.paths[p];
        if (path.kind == plan::PathKind::Support)
          continue; // No bead is pressed against it
        for (std::size_t i = path.first; i < path.first + path.count; ++i)
          if (!unsupported[i])
            carried.push_back(plan.position[i]);
      }
    if (!carried.empty()) {
      std::vector<std::pair<double, OrderedPath>> outwards;
      for (const auto& [p, stretches] : outer) {
        const plan::ToolPath& path = plan.paths[p];
        outwards.emplace_back(
            outwardsMm2(plan, stretches, carried),
            OrderedPath{p, !path.closed && leansOnLater(plan, path, stretches, unsupported)});
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

std::optional<PassResult> orderInsideOut(const UnsupportedBeads& beads, const SeenPart& /*part*/,
                                         const PassScene& scene, const base::RunContext& ctx) {
  base::require(beads.clearDirection.size() == beads.plan.waypointCount(),
                "one clear direction per waypoint");
  ctx.checkpoint();
  const std::vector<OrderedPath> order =
      insideOutOrder(beads.plan, beads.unsupported, scene.tooling);
  std::size_t inPlace = 0;
  while (inPlace < order.size() && order[inPlace] == OrderedPath{inPlace})
    ++inPlace;
  if (inPlace == order.size())
    return std::nullopt;
  PassResult out;
  out.beads.plan.fill = beads.plan.fill;
  for (const OrderedPath& next : order)
    appendPath(out.beads, beads, next);
  return out;
}

} // namespace voluta::toolpath
