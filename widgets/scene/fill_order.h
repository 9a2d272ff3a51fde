// Fill times of a plan on a coarse grid: sufficient to find the beads that end up hidden.
#pragma once

#include "plan/tool_plan.h"
#include "voxel/voxel_grid.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace voluta::scene {

inline constexpr std::uint32_t kNeverFilled = std::numeric_limits<std::uint32_t>::max();

class FillOrder {
public:
  explicit FillOrder(const plan::ToolPlan& plan);

  // Returns the waypoint at whose arrival the bead that ends at `waypoint` (coming from the one
  // before it) is surrounded on all sides; kNeverFilled if a side stays open. Precondition: it is
  // not the first of its path.
  std::uint32_t surroundedAt(const plan::ToolPlan& plan, std::size_t waypoint) const;
  // Returns the unit vector to the side that stays open permanently; zero if none does, or if
  // opposite ones do. Same precondition.
  Eigen::Vector3d openSide(const plan::ToolPlan& plan, std::size_t waypoint) const;
  // Returns whether air beside the bead reaches the outside of the finished print. Same
  // precondition.
  bool reachesOutside(const plan::ToolPlan& plan, std::size_t waypoint) const;

private:
  template <typename F>
  void forProbes(const plan::ToolPlan& plan, std::size_t waypoint, F&& f) const;
  std::uint32_t filledAt(const Eigen::Vector3d& point) const;
  void findOutside();

  voxel::VoxelGrid grid_;
  std::vector<std::uint32_t> filledAt_;
  std::vector<bool> isOutside_; // cells of air around the finished print
  bool onPlate_ = true; // closed from below; around a rod there are beads on both sides of z = 0
};

} // namespace voluta::scene
