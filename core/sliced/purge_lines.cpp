#include "sliced/purge_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::sliced {

namespace {
using Eigen::Vector2d, Eigen::Vector3d;

constexpr std::size_t kMaxPaths = 8, kMaxRuns = 12;
constexpr double kMinRunMm = 30.0, kApartMm = 5.0, kSameHeightMm = 0.01;

struct Runs {
  std::size_t count = 0;
  double longestMm = 0.0;
};

// Returns the straight runs of a path.
Runs runsOf(const SlicedPath& path) {
  constexpr double kStraight = 0.999;
  Runs runs;
  Vector3d run = Vector3d::Zero();
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Vector3d step = path.points[i].position - path.points[i - 1].position;
    if (run.norm() > 0.0 && run.dot(step) > kStraight * run.norm() * step.norm()) {
      run += step;
    } else {
      ++runs.count;
      run = step;
    }
    runs.longestMm = std::max(runs.longestMm, run.norm());
  }
  return runs;
}

// Returns whether all points are at one height, as that of the path's first one.
bool isLevel(const SlicedPath& path) {
  return std::ranges::all_of(path.points, [&](const SlicedPoint& p) {
    return std::abs(p.position.z() - path.points.front().position.z()) <= kSameHeightMm;
  });
}

Eigen::AlignedBox2d boxOf(const SlicedPath& path) {
  Eigen::AlignedBox2d box;
  for (const SlicedPoint& point : path.points)
    box.extend(Vector2d(point.position.head<2>()));
  return box;
}

// Returns whether the first `count` paths are apart from all others, which have several layers.
bool isBesideThePart(const std::vector<SlicedPath>& paths, std::size_t count) {
  std::vector<Eigen::AlignedBox2d> lines;
  for (std::size_t i = 0; i < count; ++i) {
    lines.push_back(boxOf(paths[i]));
    lines.back().min().array() -= kApartMm;
    lines.back().max().array() += kApartMm;
  }
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = count; i < paths.size(); ++i) {
    const Eigen::AlignedBox2d box = boxOf(paths[i]);
    if (std::ranges::any_of(lines, [&](const auto& line) { return line.intersects(box); }))
      return false;
    for (const SlicedPoint& point : paths[i].points) {
      low = std::min(low, point.position.z());
      high = std::max(high, point.position.z());
    }
  }
  return high > low + kSameHeightMm;
}
} // namespace

void leaveOutPurgeLines(SlicedFile& file) {
  std::size_t count = 0, runs = 0;
  double longest = 0.0;
  std::vector<double> longestOf;
  for (const SlicedPath& path : file.paths) {
    const Runs own = runsOf(path);
    runs += own.count;
    if (path.kind || count == kMaxPaths || runs > kMaxRuns || !isLevel(path) ||
        std::abs(path.points.front().position.z() -
                 file.paths.front().points.front().position.z()) > kSameHeightMm)
      break;
    longest = std::max(longest, own.longestMm);
    longestOf.push_back(longest);
    ++count;
  }
  while (count > 0 && (longestOf[count - 1] < kMinRunMm || !isBesideThePart(file.paths, count)))
    --count;
  for (std::size_t i = 0; i < count; ++i)
    for (const SlicedPoint& point : file.paths[i].points) {
      file.purged += point.extruded;
      file.outside.push_back({point.line, point.extruded});
    }
  if (count > 0)
    file.purgeLine = file.paths.front().line;
  file.paths.erase(file.paths.begin(), file.paths.begin() + static_cast<std::ptrdiff_t>(count));
}

} // namespace voluta::sliced
