#include "toolpath/coverage/segment_grid.h"

namespace voluta::toolpath {

namespace {
constexpr double kReachCells = 1.8; // Cells spanned by the reach of fine beads
} // namespace

SegmentGrid::SegmentGrid(const std::vector<Segment>& segments, double reachMm)
    : reach_(reachMm), cell_(std::min(1.0, reachMm / kReachCells)) {
  if (segments.empty()) {
    start_.assign(1, 0);
    return;
  }
  Eigen::Vector3d low = segments.front().a, high = low;
  rays_.reserve(segments.size());
  for (const Segment& s : segments) {
    const Eigen::Vector3d ab = s.b - s.a;
    const double squared = ab.squaredNorm();
    rays_.push_back({s.a, ab, squared > 0.0 ? 1.0 / squared : 0.0});
    low = low.cwiseMin(s.a).cwiseMin(s.b);
    high = high.cwiseMax(s.a).cwiseMax(s.b);
  }
  low_ = low - Eigen::Vector3d::Constant(1e-6);
  // A patch fills little of its bounding box: limit the grid to the memory of a few cells per
  // segment.
  const double limit = 4e6;
  const Eigen::Vector3d extent = high - low_ + Eigen::Vector3d::Constant(1e-6);
  for (;; cell_ *= 1.5) {
    const Eigen::Vector3d cells = (extent / cell_).array().ceil().max(1.0);
    if (cells.prod() <= limit) {
      size_ = cells.cast<int>();
      break;
    }
  }
  inverse_ = 1.0 / cell_;
  const auto cellRange = [&](const Segment& s, auto&& f) {
    Eigen::Vector3i lo, hi;
    for (int k = 0; k < 3; ++k) {
      lo[k] = std::clamp(static_cast<int>((std::min(s.a[k], s.b[k]) - low_[k]) * inverse_), 0,
                         size_[k] - 1);
      hi[k] = std::clamp(static_cast<int>((std::max(s.a[k], s.b[k]) - low_[k]) * inverse_), 0,
                         size_[k] - 1);
    }
    for (int z = lo.z(); z <= hi.z(); ++z)
      for (int y = lo.y(); y <= hi.y(); ++y)
        for (int x = lo.x(); x <= hi.x(); ++x)
          f(cellAt(x, y, z));
  };
  start_.assign(static_cast<std::size_t>(size_.prod()) + 1, 0);
  for (const Segment& s : segments)
    cellRange(s, [&](std::size_t c) { ++start_[c + 1]; });
  for (std::size_t c = 1; c < start_.size(); ++c)
    start_[c] += start_[c - 1];
  entry_.resize(static_cast<std::size_t>(start_.back()));
  std::vector<int> fill(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < segments.size(); ++i)
    cellRange(segments[i], [&](std::size_t c) {
      entry_[static_cast<std::size_t>(fill[c]++)] = static_cast<int>(i);
    });
}

SegmentGrid::Hit SegmentGrid::nearest(const Eigen::Vector3d& p, int likely) const {
  Hit best;
  double minimum = reach_ * reach_;
  // Most points have a neighbour within half a cell: search there first.
  double first = std::min(0.6 * cell_, reach_);
  if (likely >= 0)
    if (const auto [t, squared] = measure(likely, p); squared < minimum) {
      best.segment = likely;
      best.t = t;
      minimum = squared;
      first = std::min(first, std::sqrt(squared));
    }
  for (double radius = first;; radius = std::min(2 * radius, reach_)) {
    visit(p, radius, [&](int i) {
      const auto [t, squared] = measure(i, p);
      if (squared < minimum || (squared == minimum && best.segment > i)) {
        best.segment = i;
        best.t = t;
        minimum = squared;
      }
    });
    if (radius >= reach_ || (best.segment >= 0 && minimum <= radius * radius))
      break;
  }
  best.distanceMm = std::sqrt(minimum);
  if (best.segment >= 0) {
    const Ray& s = rays_[static_cast<std::size_t>(best.segment)];
    best.point = s.a + best.t * s.ab;
  }
  return best;
}

} // namespace voluta::toolpath
