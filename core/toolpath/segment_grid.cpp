#include "toolpath/segment_grid.h"

namespace voluta::toolpath {

namespace {
constexpr double kReachCells = 1.8; // cells that the reach of fine beads spans
} // namespace

SegmentGrid::SegmentGrid(std::vector<Segment> segments, double reachMm)
    : segments_(std::move(segments)), reach_(reachMm), cell_(std::min(1.0, reachMm / kReachCells)) {
  if (segments_.empty()) {
    start_.assign(1, 0);
    return;
  }
  Eigen::Vector3d low = segments_.front().a, high = low;
  for (const Segment& s : segments_) {
    low = low.cwiseMin(s.a).cwiseMin(s.b);
    high = high.cwiseMax(s.a).cwiseMax(s.b);
  }
  low_ = low - Eigen::Vector3d::Constant(1e-6);
  // A patch hardly fills its box: the grid stays below a few cells a segment's worth of memory.
  const double most = 4e6;
  const Eigen::Vector3d extent = high - low_ + Eigen::Vector3d::Constant(1e-6);
  for (;; cell_ *= 1.5) {
    const Eigen::Vector3d cells = (extent / cell_).array().ceil().max(1.0);
    if (cells.prod() <= most) {
      size_ = cells.cast<int>();
      break;
    }
  }
  const auto cellRange = [&](const Segment& s, auto&& f) {
    Eigen::Vector3i lo, hi;
    for (int k = 0; k < 3; ++k) {
      lo[k] = std::clamp(static_cast<int>((std::min(s.a[k], s.b[k]) - low_[k]) / cell_), 0,
                         size_[k] - 1);
      hi[k] = std::clamp(static_cast<int>((std::max(s.a[k], s.b[k]) - low_[k]) / cell_), 0,
                         size_[k] - 1);
    }
    for (int z = lo.z(); z <= hi.z(); ++z)
      for (int y = lo.y(); y <= hi.y(); ++y)
        for (int x = lo.x(); x <= hi.x(); ++x)
          f(cellAt(x, y, z));
  };
  start_.assign(static_cast<std::size_t>(size_.prod()) + 1, 0);
  for (const Segment& s : segments_)
    cellRange(s, [&](std::size_t c) { ++start_[c + 1]; });
  for (std::size_t c = 1; c < start_.size(); ++c)
    start_[c] += start_[c - 1];
  entry_.resize(static_cast<std::size_t>(start_.back()));
  std::vector<int> fill(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < segments_.size(); ++i)
    cellRange(segments_[i], [&](std::size_t c) {
      entry_[static_cast<std::size_t>(fill[c]++)] = static_cast<int>(i);
    });
}

std::pair<double, double> SegmentGrid::measure(int segment, const Eigen::Vector3d& p) const {
  const Segment& s = segments_[static_cast<std::size_t>(segment)];
  const Eigen::Vector3d ab = s.b - s.a;
  const double l2 = ab.squaredNorm();
  const double t = l2 > 0 ? std::clamp(ab.dot(p - s.a) / l2, 0.0, 1.0) : 0.0;
  return {t, (s.a + t * ab - p).norm()};
}

SegmentGrid::Hit SegmentGrid::nearest(const Eigen::Vector3d& p, int likely) const {
  Hit best;
  best.distanceMm = reach_;
  // Most points have a neighbour within half a cell: look there first.
  double first = std::min(0.6 * cell_, reach_);
  if (likely >= 0)
    if (const auto [t, d] = measure(likely, p); d < reach_) {
      best.segment = likely;
      best.t = t;
      best.distanceMm = d;
      first = std::min(first, d);
    }
  for (double radius = first;; radius = std::min(2 * radius, reach_)) {
    visit(p, radius, [&](int i) {
      const auto [t, d] = measure(i, p);
      if (d < best.distanceMm || (d == best.distanceMm && best.segment > i)) {
        best.segment = i;
        best.t = t;
        best.distanceMm = d;
      }
    });
    if (radius >= reach_ || (best.segment >= 0 && best.distanceMm <= radius))
      break;
  }
  if (best.segment >= 0) {
    const Segment& s = segments_[static_cast<std::size_t>(best.segment)];
    best.point = s.a + best.t * (s.b - s.a);
  }
  return best;
}

} // namespace voluta::toolpath
