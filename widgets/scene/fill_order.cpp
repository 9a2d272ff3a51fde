#include "scene/fill_order.h"

#include "base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::scene {

namespace {

// Beads farther apart than this number of cells count as open: a cell is as wide as a bead, and the
// next cell's beads must not be mistaken for the bead itself.
constexpr double kReachInCells = 1.4;
constexpr double kMaxCells = 4e7;
constexpr int kProbes = 8;

Eigen::Vector3d centreOf(const plan::ToolPlan& plan, std::size_t i) {
  return plan.position[i] - 0.5 * double(plan.heightMm[i]) * plan.direction[i];
}

} // namespace

FillOrder::FillOrder(const plan::ToolPlan& plan) {
  Eigen::AlignedBox3d box;
  double width = 0.0;
  for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
    box.extend(plan.position[i]);
    width += plan.widthMm[i];
  }
  if (box.isEmpty())
    return;
  onPlate_ = box.min().z() >= 0.0;
  grid_.pitch = std::max(0.1, width / static_cast<double>(plan.waypointCount()));
  const Eigen::Vector3d sizes = box.sizes().array() + 4 * grid_.pitch;
  grid_.pitch = std::max(grid_.pitch, std::cbrt(sizes.prod() / kMaxCells));
  grid_.origin = box.min() - Eigen::Vector3d::Constant(2 * grid_.pitch);
  grid_.size = (sizes / grid_.pitch).array().ceil().matrix().cast<int>();
  filledAt_.assign(grid_.cellCount(), kNeverFilled);
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      const Eigen::Vector3d to = centreOf(plan, i);
      const Eigen::Vector3d from = i > path.first ? centreOf(plan, i - 1) : to;
      const int steps =
          std::max(1, static_cast<int>(std::ceil(2 * (to - from).norm() / grid_.pitch)));
      for (int s = 0; s <= steps; ++s) {
        const Eigen::Vector3i c = grid_.cellOf(from + (to - from) * (double(s) / steps));
        if (!grid_.contains(c.x(), c.y(), c.z()))
          continue;
        std::uint32_t& cell = filledAt_[grid_.index(c.x(), c.y(), c.z())];
        cell = std::min(cell, static_cast<std::uint32_t>(i));
      }
    }
  findOutside();
}

// Air spreads from the rim of the grid, which the beads do not touch, through the faces of cells.
// The platform stops it.
void FillOrder::findOutside() {
  isOutside_.assign(grid_.cellCount(), false);
  std::vector<Eigen::Vector3i> next;
  const auto visit = [&](const Eigen::Vector3i& c) {
    if (!grid_.contains(c.x(), c.y(), c.z()))
      return;
    const std::size_t cell = grid_.index(c.x(), c.y(), c.z());
    if (isOutside_[cell] || filledAt_[cell] != kNeverFilled ||
        (onPlate_ && grid_.centre(c.x(), c.y(), c.z()).z() < 0.0))
      return;
    isOutside_[cell] = true;
    next.push_back(c);
  };
  visit(grid_.size - Eigen::Vector3i::Ones());
  while (!next.empty()) {
    const Eigen::Vector3i c = next.back();
    next.pop_back();
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        Eigen::Vector3i beside = c;
        beside[axis] += step;
        visit(beside);
      }
  }
}

std::uint32_t FillOrder::filledAt(const Eigen::Vector3d& point) const {
  const Eigen::Vector3i c = grid_.cellOf(point);
  return grid_.contains(c.x(), c.y(), c.z()) ? filledAt_[grid_.index(c.x(), c.y(), c.z())]
                                             : kNeverFilled;
}

// Calls f(direction, fill time) for eight directions around the bead.
template <typename F>
void FillOrder::forProbes(const plan::ToolPlan& plan, std::size_t waypoint, F&& f) const {
  const Eigen::Vector3d a = centreOf(plan, waypoint - 1), b = centreOf(plan, waypoint);
  const Eigen::Vector3d middle = (a + b) / 2;
  const Eigen::Vector3d up = plan.direction[waypoint];
  const Eigen::Vector3d side = (b - a).cross(up).normalized();
  const double reach = kReachInCells * grid_.pitch;
  for (int i = 0; i < kProbes; ++i) {
    const double angle = 2 * base::kPi * i / kProbes;
    const Eigen::Vector3d direction = std::cos(angle) * side + std::sin(angle) * up;
    const Eigen::Vector3d probe = middle + reach * direction;
    // The platform closes beads on it from below.
    f(direction, onPlate_ && probe.z() < 0.0 ? 0 : filledAt(probe));
  }
}

std::uint32_t FillOrder::surroundedAt(const plan::ToolPlan& plan, std::size_t waypoint) const {
  std::uint32_t last = 0;
  forProbes(plan, waypoint,
            [&](const Eigen::Vector3d&, std::uint32_t filled) { last = std::max(last, filled); });
  return last;
}

bool FillOrder::reachesOutside(const plan::ToolPlan& plan, std::size_t waypoint) const {
  const Eigen::Vector3d a = centreOf(plan, waypoint - 1), b = centreOf(plan, waypoint);
  bool reaches = false;
  forProbes(plan, waypoint, [&](const Eigen::Vector3d& direction, std::uint32_t filled) {
    if (filled != kNeverFilled || reaches)
      return;
    const Eigen::Vector3i c = grid_.cellOf((a + b) / 2 + kReachInCells * grid_.pitch * direction);
    reaches = !grid_.contains(c.x(), c.y(), c.z()) || isOutside_[grid_.index(c.x(), c.y(), c.z())];
  });
  return reaches;
}

Eigen::Vector3d FillOrder::openSide(const plan::ToolPlan& plan, std::size_t waypoint) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int open = 0;
  forProbes(plan, waypoint, [&](const Eigen::Vector3d& direction, std::uint32_t filled) {
    if (filled == kNeverFilled) {
      sum += direction;
      ++open;
    }
  });
  // More than half open: a thin wall or a single bead, visible from all sides.
  const bool oneSided = open > 0 && open <= kProbes / 2 && sum.norm() > 0.9;
  return oneSided ? Eigen::Vector3d(sum.normalized()) : Eigen::Vector3d::Zero();
}

} // namespace voluta::scene
