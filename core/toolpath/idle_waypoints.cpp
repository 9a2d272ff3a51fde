#include "toolpath/idle_waypoints.h"

#include "geometry/nearest_share.h"
#include "plan/waypoints.h"

#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

constexpr double kLongestWidths = 6.0; // of a segment
constexpr double kSameDirection = 1e-6;
constexpr double kSameSection = 0.02; // share of width and height
constexpr float kSameSpeed = 1e-3F;   // [mm/s]

class Segments {
public:
  Segments(const plan::ToolPlan& plan, double chordMm, double longestMm)
      : plan_(plan), chordMm_(chordMm), longestMm_(longestMm) {}

  // Returns the last waypoint up to `end` that one straight segment from `from` reaches.
  std::size_t reached(std::size_t from, std::size_t end) const {
    std::size_t to = from + 1;
    while (to < end && isOneSegment(from, to + 1))
      ++to;
    return to;
  }

private:
  bool isOneSegment(std::size_t from, std::size_t to) const {
    const Vector3d &a = plan_.position[from], &b = plan_.position[to];
    if ((b - a).norm() >
            std::min(longestMm_, kLongestWidths * static_cast<double>(plan_.widthMm[from])) ||
        !hasSameDirection(from, to) ||
        std::abs(plan_.speedMmPerS[to] - plan_.speedMmPerS[from + 1]) > kSameSpeed)
      return false;
    double last = 0.0;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double share = geometry::nearestShare(plan_.position[i], a, b);
      if (share < last || (a + share * (b - a) - plan_.position[i]).norm() > chordMm_ ||
          !isEven(plan_.widthMm, from, to, i, share) || !isEven(plan_.heightMm, from, to, i, share))
        return false;
      last = share;
    }
    return true;
  }
  bool hasSameDirection(std::size_t i, std::size_t k) const {
    return (plan_.direction[i] - plan_.direction[k]).squaredNorm() <
           kSameDirection * kSameDirection;
  }
  static bool isEven(const std::vector<float>& values, std::size_t from, std::size_t to,
                     std::size_t i, double share) {
    const double here = static_cast<double>(values[i]),
                 even = (1.0 - share) * static_cast<double>(values[from]) +
                        share * static_cast<double>(values[to]);
    return std::abs(here - even) <= kSameSection * here;
  }

  const plan::ToolPlan& plan_;
  double chordMm_, longestMm_;
};

bool hasPlastic(const plan::ToolPath& path) {
  return path.kind != plan::PathKind::Tape && path.kind != plan::PathKind::Shot &&
         !plan::isWaste(path.kind);
}
} // namespace

plan::ToolPlan withoutIdleWaypoints(const plan::ToolPlan& plan, double chordMm, double longestMm) {
  const Segments segments(plan, chordMm, longestMm);
  plan::ToolPlan thin;
  thin.fill = plan.fill;
  for (plan::ToolPath path : plan.paths) {
    const std::size_t last = path.first + path.count - 1, first = thin.waypointCount();
    plan::appendWaypoint(thin, plan, path.first);
    for (std::size_t i = path.first; i < last;) {
      i = hasPlastic(path) ? segments.reached(i, last) : i + 1;
      plan::appendWaypoint(thin, plan, i);
    }
    path.first = first;
    path.count = thin.waypointCount() - first;
    thin.paths.push_back(path);
  }
  return thin;
}

bool hasOneDirection(const plan::ToolPlan& plan) {
  return std::ranges::all_of(plan.direction, [&](const Vector3d& d) {
    return (d - plan.direction.front()).squaredNorm() < kSameDirection * kSameDirection;
  });
}

} // namespace voluta::toolpath
