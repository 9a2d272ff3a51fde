#include "toolpath/plane/spaced_points.h"

#include "geometry/nearest_share.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector2d;

double distance(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  return (p - a - geometry::nearestShare(p, a, b) * (b - a)).norm();
}

// Returns the points to keep, by their numbers, ascending.
std::vector<std::size_t> keptPoints(const std::vector<Vector2d>& points, double chordMm) {
  std::vector<char> isKept(points.size(), 0);
  isKept.front() = isKept.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double farthest = chordMm;
    std::size_t split = 0;
    for (std::size_t i = from + 1; i < to; ++i)
      if (const double d = distance(points[i], points[from], points[to]); d > farthest) {
        farthest = d;
        split = i;
      }
    if (split == 0)
      continue;
    isKept[split] = 1;
    open.emplace_back(from, split);
    open.emplace_back(split, to);
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (isKept[i])
      kept.push_back(i);
  return kept;
}
} // namespace

PlaneLine spacedPoints(const PlaneLine& line, double chordMm, double stepMm) {
  std::vector<Vector2d> points = line.points;
  if (line.isClosed) {
    points.push_back(points.front());
    // A closed line has no ends from which distances could be measured: split it at its farthest
    // point.
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if ((points[i] - points[0]).squaredNorm() > (points[farthest] - points[0]).squaredNorm())
        farthest = i;
    std::ranges::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(farthest),
                        points.end() - 1);
    points.back() = points.front();
  }
  PlaneLine spaced{{}, line.isClosed};
  std::size_t last = 0;
  for (const std::size_t next : keptPoints(points, chordMm)) {
    if (next == 0)
      continue;
    const double length = (points[next] - points[last]).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(length / stepMm - 1e-9)));
    for (int k = 0; k < steps; ++k)
      spaced.points.push_back(points[last] +
                              static_cast<double>(k) / steps * (points[next] - points[last]));
    last = next;
  }
  if (!line.isClosed)
    spaced.points.push_back(points[last]);
  return spaced;
}

} // namespace voluta::toolpath
