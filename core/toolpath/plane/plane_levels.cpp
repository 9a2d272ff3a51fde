#include "toolpath/plane/plane_levels.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

namespace voluta::toolpath {

namespace {
// [thicknesses]: as of LayerCount
constexpr double kGap = 1.7, kSameLayer = 0.3;
constexpr double kSameDirection = 1e-9;
} // namespace

PlaneLevels::PlaneLevels(const layers::LayerStack& stack, const base::RunContext& ctx)
    : patches_(stack.patches.size()), levelOf_(stack.patches.size(), 0) {
  const auto isSupport = [&](std::size_t i) {
    return stack.patches[i].group == layers::kSupportGroup;
  };
  base::parallelChunks(ctx, patches_.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (!isSupport(i))
        if (auto plane = planePatch(stack.patches[i]); plane && plane->seams.empty())
          patches_[i] = std::move(plane);
  });
  std::set<int> curved; // items
  for (std::size_t i = 0; i < patches_.size(); ++i)
    if (!patches_[i] && !isSupport(i) && !stack.patches[i].surface.empty())
      curved.insert(stack.patches[i].item);
  std::vector<Eigen::Vector3d> directions;
  // Regions with layers of their own are stacks of their own.
  std::vector<std::tuple<int, int, std::size_t, double, std::size_t>> order;
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    if (curved.contains(stack.patches[i].item))
      patches_[i].reset();
    if (!patches_[i])
      continue;
    const auto known = std::ranges::find_if(directions, [&](const Eigen::Vector3d& d) {
      return (d - patches_[i]->direction).norm() < kSameDirection;
    });
    const auto direction = static_cast<std::size_t>(known - directions.begin());
    if (known == directions.end())
      directions.push_back(patches_[i]->direction);
    const int region = std::max(0, stack.patches[i].group - layers::kRegionGroups + 1);
    order.emplace_back(stack.patches[i].item, region, direction, patches_[i]->heightMm, i);
  }
  std::ranges::sort(order);
  std::size_t stackNumber = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& [item, region, direction, height, i] = order[k];
    const bool isSameStack = k > 0 && std::get<0>(order[k - 1]) == item &&
                             std::get<1>(order[k - 1]) == region &&
                             std::get<2>(order[k - 1]) == direction;
    stackNumber += isSameStack ? 0 : 1;
    const double thickness = patches_[i]->thicknessMm;
    if (!isSameStack || height - levels_.back().middleMm >
                            kSameLayer * std::min(thickness, levels_.back().thicknessMm)) {
      levels_.push_back({{}, height, thickness});
      stackOf_.push_back(stackNumber);
    }
    levels_.back().patches.push_back(i);
    levelOf_[i] = levels_.size() - 1;
  }
}

const PlanePatch* PlaneLevels::patch(std::size_t index) const {
  return patches_[index] ? &*patches_[index] : nullptr;
}

std::vector<const PlaneLevels::Level*> PlaneLevels::from(std::size_t index, int sign,
                                                         int count) const {
  std::vector<const Level*> found;
  auto at = static_cast<std::ptrdiff_t>(levelOf_[index]);
  for (int k = 0; k < count; ++k) {
    const std::ptrdiff_t next = at + sign;
    if (next < 0 || next >= std::ssize(levels_))
      break;
    const Level &here = levels_[static_cast<std::size_t>(at)],
                &there = levels_[static_cast<std::size_t>(next)];
    if (stackOf_[static_cast<std::size_t>(next)] != stackOf_[static_cast<std::size_t>(at)] ||
        std::abs(there.middleMm - here.middleMm) >
            kGap * std::max(here.thicknessMm, there.thicknessMm))
      break;
    found.push_back(&there);
    at = next;
  }
  return found;
}

ClipperLib::Paths PlaneLevels::outline(const Level& level) const {
  ClipperLib::Paths all;
  for (const std::size_t i : level.patches)
    std::ranges::copy(patches_[i]->outline, std::back_inserter(all));
  return all;
}

} // namespace voluta::toolpath
