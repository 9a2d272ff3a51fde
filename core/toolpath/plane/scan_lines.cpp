#include "toolpath/plane/scan_lines.h"

#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

using Eigen::Vector2d;

std::vector<ContourEdge> edgesOf(const ClipperLib::Paths& paths) {
  std::vector<ContourEdge> edges;
  for (const ClipperLib::Path& path : paths)
    for (std::size_t i = 0; i < path.size(); ++i)
      edges.push_back({geometry::pointMm(path[i]), geometry::pointMm(path[(i + 1) % path.size()])});
  return edges;
}

ScanLines::ScanLines(double directionRad, double firstMm, double spacingMm, std::size_t count)
    : along_(std::cos(directionRad), std::sin(directionRad)), across_(-along_.y(), along_.x()),
      firstMm_(firstMm), spacingMm_(spacingMm), count_(count) {}

ScanLines ScanLines::over(const std::vector<ContourEdge>& edges, double directionRad,
                          double wantedMm) {
  const Vector2d across(-std::sin(directionRad), std::cos(directionRad));
  double low = INFINITY, high = -INFINITY;
  for (const ContourEdge& edge : edges) {
    low = std::min(low, across.dot(edge.from));
    high = std::max(high, across.dot(edge.from));
  }
  const double count = std::max(1.0, std::round((high - low) / wantedMm));
  const double spacing = (high - low) / count;
  return {directionRad, low + 0.5 * spacing, spacing, static_cast<std::size_t>(count)};
}

std::vector<std::vector<Interval>>
ScanLines::inside(const std::vector<ContourEdge>& contours) const {
  std::vector<std::vector<double>> crossings(count_);
  for (const ContourEdge& edge : contours) {
    const double a = (across_.dot(edge.from) - firstMm_) / spacingMm_,
                 b = (across_.dot(edge.to) - firstMm_) / spacingMm_;
    const double low = std::ceil(std::max(0.0, std::min(a, b))),
                 high = std::min(std::max(a, b), static_cast<double>(count_));
    for (double line = low; line < high; line += 1.0)
      crossings[static_cast<std::size_t>(line)].push_back(
          along_.dot(edge.from + (line - a) / (b - a) * (edge.to - edge.from)));
  }
  std::vector<std::vector<Interval>> stretches(count_);
  for (std::size_t i = 0; i < count_; ++i) {
    std::ranges::sort(crossings[i]);
    for (std::size_t k = 0; k + 1 < crossings[i].size(); k += 2)
      stretches[i].emplace_back(crossings[i][k], crossings[i][k + 1]);
  }
  return stretches;
}

std::vector<Interval> mergedIntervals(std::vector<Interval> stretches) {
  std::ranges::sort(stretches);
  std::vector<Interval> all;
  for (const Interval& one : stretches)
    if (all.empty() || one.first > all.back().second)
      all.push_back(one);
    else
      all.back().second = std::max(all.back().second, one.second);
  return all;
}

} // namespace voluta::toolpath
