#include "milling/stock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::milling {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// The volume that a ball-ended cutter sweeps on a straight line.
class Sweep {
public:
  Sweep(double radiusMm, const Vector3d& from, const Vector3d& to) : radius_(radiusMm) {
    constexpr double kStraightDownMm = 1e-9;
    const Vector2d step = (to - from).head<2>();
    const double length = step.norm();
    if (length > kStraightDownMm) {
      along_ = step / length;
      length_ = length;
      slope_ = (to.z() - from.z()) / length;
      startZ_ = from.z();
    } else {
      startZ_ = std::min(from.z(), to.z());
    }
    lean_ = slope_ / std::sqrt(1.0 + slope_ * slope_);
  }

  // Returns the height of its lower side at a place, given from the line's start; infinity beside
  // it. Of the ball at s along the line, the lower side at u along it and p beside it is
  // z(s) + r - sqrt(r2 - p2 - (u - s)2), which is convex in s.
  double bottomAt(const Vector2d& place) const {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const double u = place.dot(along_), p = place.x() * along_.y() - place.y() * along_.x(),
                 square = radius_ * radius_ - p * p;
    if (square < 0.0)
      return kNone;
    const double half = std::sqrt(square), first = std::max(0.0, u - half),
                 last = std::min(length_, u + half);
    if (first > last)
      return kNone;
    const double s = std::clamp(u - half * lean_, first, last);
    return startZ_ + slope_ * s + radius_ - std::sqrt(std::max(0.0, square - (u - s) * (u - s)));
  }

private:
  Vector2d along_ = Vector2d::UnitX();
  double radius_, length_ = 0.0, slope_ = 0.0, lean_ = 0.0, startZ_ = 0.0;
};

} // namespace

Stock::Stock(const Eigen::AlignedBox3d& block, double pitchMm)
    : grid_(gridOver(block.min().head<2>(), block.max().head<2>(), pitchMm)),
      low_(grid_.size(), block.min().z()), high_(grid_.size(), block.max().z()),
      top_(block.max().z()) {}

double Stock::volumeMm3() const {
  double height = 0.0;
  for (std::size_t c = 0; c < grid_.size(); ++c)
    height += std::max(0.0, high_[c] - low_[c]);
  return height * grid_.pitchMm * grid_.pitchMm;
}

double Stock::cut(const Cutter& cutter, const Vector3d& from, const Vector3d& to) {
  const double lowestTip = std::min(from.z(), to.z());
  if (lowestTip >= top_)
    return 0.0;
  const Sweep sweep(cutter.radiusMm(), from, to);
  double removed = 0.0;
  visitAlong(grid_, from.head<2>(), to.head<2>(), cutter.radiusMm(),
             [&](std::size_t cell, const Vector2d& place) {
               if (high_[cell] <= lowestTip)
                 return;
               const double bottom = sweep.bottomAt(place);
               if (bottom >= high_[cell])
                 return;
               removed += std::max(0.0, high_[cell] - std::max(bottom, low_[cell]));
               high_[cell] = bottom;
             });
  return removed * grid_.pitchMm * grid_.pitchMm;
}

Stock Stock::turned() const {
  Stock out = *this;
  out.top_ = -*std::ranges::min_element(low_);
  out.grid_.low.y() = -(grid_.low.y() + grid_.pitchMm * grid_.countY);
  for (int j = 0; j < grid_.countY; ++j)
    for (int i = 0; i < grid_.countX; ++i) {
      const std::size_t from = grid_.index(i, j), to = grid_.index(i, grid_.countY - 1 - j);
      out.low_[to] = -high_[from];
      out.high_[to] = -low_[from];
    }
  return out;
}

} // namespace voluta::milling
