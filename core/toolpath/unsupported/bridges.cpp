#include "toolpath/unsupported/bridges.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "collision/growing_part.h"
#include "geometry/convex_polygon.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"

#include <algorithm>
#include <array>

namespace voluta::toolpath {

namespace {

using Eigen::Vector3d;

// The same criteria as in the replay: support counts at any of these depths below the tip, in bead
// heights; material printed by the same path within the last kSoftMm, or two bead widths, is still
// soft and carries nothing.
constexpr std::array kBelow{1.05, 1.15, 1.25};
constexpr double kSoftMm = 3.0;

Vector3d along(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t i) {
  const std::size_t before = i > path.first ? i - 1 : i,
                    after = i + 1 < path.first + path.count ? i + 1 : i;
  return plan.position[after] - plan.position[before];
}

Vector3d sideAcross(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t waypoint,
                    const Vector3d& direction) {
  const Vector3d side = direction.cross(along(plan, path, waypoint));
  return side.squaredNorm() > 1e-12 ? side.normalized() : direction.unitOrthogonal();
}

// Returns the first waypoint of the still soft material before waypoint i of the path.
std::size_t softSince(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t i) {
  double length = std::max(kSoftMm, 2.0 * static_cast<double>(plan.widthMm[i]));
  while (i > path.first && length > 0.0) {
    length -= (plan.position[i] - plan.position[i - 1]).norm();
    --i;
  }
  return i;
}

bool onPlate(const platform::PlatformSolid& platform, const Vector3d& point) {
  return point.z() <= 0.0 && platform.polygon.size() >= 3 &&
         geometry::inConvexPolygon(platform.polygon, point.head<2>());
}

// Inverts stretches of `value` shorter than `minMm`. Stretches of supported waypoints at an end
// of the path are kept at any length.
void dropShort(const plan::ToolPlan& plan, const plan::ToolPath& path, char value, double minMm,
               std::vector<char>& marks) {
  const std::size_t end = path.first + path.count;
  for (std::size_t b = path.first; b < end;) {
    std::size_t e = b;
    double length = 0.0;
    while (e < end && marks[e] == marks[b]) {
      ++e;
      if (e < end)
        length += (plan.position[e] - plan.position[e - 1]).norm();
    }
    const bool inner = b > path.first && e < end;
    if (marks[b] == value && length < minMm && (value == 1 || inner))
      std::fill(marks.begin() + static_cast<std::ptrdiff_t>(b),
                marks.begin() + static_cast<std::ptrdiff_t>(e), static_cast<char>(1 - value));
    b = e;
  }
}

} // namespace

Vector3d sideOf(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t waypoint) {
  return sideAcross(plan, path, waypoint, plan.direction[waypoint]);
}

int supportedSamples(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t waypoint,
                     const Vector3d& tip, const Vector3d& direction,
                     const collision::GrowingPart& part, const platform::PlatformSolid& platform,
                     int enough) {
  const auto height = static_cast<double>(plan.heightMm[waypoint]);
  const Vector3d side = sideAcross(plan, path, waypoint, direction);
  const std::size_t before = softSince(plan, path, waypoint);
  int places = 0;
  for (int k = 0; k < kPlacesAcross && places < enough; ++k) {
    const double offset =
        ((k + 0.5) / kPlacesAcross - 0.5) * static_cast<double>(plan.widthMm[waypoint]);
    places += std::ranges::any_of(kBelow, [&](double share) {
      const Vector3d point = tip + offset * side - share * height * direction;
      return onPlate(platform, point) || part.holds(point, before);
    });
  }
  return places;
}

std::vector<char> unsupportedWaypoints(const plan::ToolPlan& plan,
                                       const collision::GrowingPart& part,
                                       const platform::PlatformSolid& platform,
                                       const base::RunContext& ctx, int minPlaces) {
  std::vector<char> unsupported(plan.waypointCount(), 0);
  base::parallelChunks(ctx, plan.paths.size(), 1, [&](std::size_t b, std::size_t e) {
    for (std::size_t p = b; p < e && !ctx.cancelled(); ++p) {
      const plan::ToolPath& path = plan.paths[p];
      if (plan::isWaste(path.kind))
        continue;
      double width = 0.0;
      for (std::size_t i = path.first; i < path.first + path.count; ++i) {
        unsupported[i] = supportedSamples(plan, path, i, plan.position[i], plan.direction[i], part,
                                          platform, minPlaces) < minPlaces;
        width = std::max(width, static_cast<double>(plan.widthMm[i]));
      }
      dropShort(plan, path, 0, width, unsupported);
      dropShort(plan, path, 1, width, unsupported);
    }
  });
  ctx.checkpoint();
  return unsupported;
}

std::vector<UnsupportedStretch> unsupportedStretches(const plan::ToolPlan& plan,
                                                     const plan::ToolPath& path,
                                                     const std::vector<char>& unsupported,
                                                     double longerThanMm) {
  std::vector<UnsupportedStretch> stretches;
  const std::size_t end = path.first + path.count;
  for (std::size_t b = path.first; b < end;) {
    std::size_t e = b;
    double length = 0.0;
    for (; e < end && unsupported[e]; ++e)
      length += e > b ? (plan.position[e] - plan.position[e - 1]).norm() : 0.0;
    if (length > longerThanMm)
      stretches.push_back({b, e});
    b = std::max(e, b + 1);
  }
  return stretches;
}

} // namespace voluta::toolpath
