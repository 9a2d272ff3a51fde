#include "toolpath/plane/level_patches.h"

#include "base/parallel.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace voluta::toolpath {

bool isLevel(const PlanePatch& plane) {
  constexpr double kUprightCosine = 0.999;
  return plane.direction.z() >= kUprightCosine;
}

LevelPatches::LevelPatches(const layers::LayerStack& stack, const base::RunContext& ctx)
    : planes_(stack.patches.size()), boxes_(stack.patches.size()) {
  base::parallelChunks(ctx, planes_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (auto plane = planePatch(stack.patches[i]); plane && isLevel(*plane)) {
        boxes_[i] = boxOf(*plane);
        planes_[i] = std::move(plane);
      }
  });
  for (std::size_t i = 0; i < planes_.size(); ++i)
    if (planes_[i])
      byHeight_.push_back(i);
  std::ranges::stable_sort(byHeight_, {}, [&](std::size_t i) { return planes_[i]->heightMm; });
}

bool LevelPatches::Box::touches(const Box& other) const {
  return low.X <= other.high.X && other.low.X <= high.X && low.Y <= other.high.Y &&
         other.low.Y <= high.Y;
}

LevelPatches::Box LevelPatches::boxOf(const PlanePatch& plane) {
  constexpr auto kFar = std::numeric_limits<ClipperLib::cInt>::max();
  Box box{{kFar, kFar}, {-kFar, -kFar}};
  for (const ClipperLib::Paths* paths : {&plane.outline, &plane.seams})
    for (const ClipperLib::Path& path : *paths)
      for (const ClipperLib::IntPoint& p : path)
        box = {{std::min(box.low.X, p.X), std::min(box.low.Y, p.Y)},
               {std::max(box.high.X, p.X), std::max(box.high.Y, p.Y)}};
  return box;
}

const PlanePatch* LevelPatches::patch(std::size_t index) const {
  return planes_[index] ? &*planes_[index] : nullptr;
}

ClipperLib::Paths LevelPatches::below(const PlanePatch& layer) const {
  // [thicknesses] between two layers that follow each other
  constexpr double kNearest = 0.3, kFarthest = 1.7;
  const Box box = boxOf(layer);
  ClipperLib::Paths all;
  auto at = std::ranges::lower_bound(byHeight_, layer.heightMm - kFarthest * layer.thicknessMm, {},
                                     [&](std::size_t i) { return planes_[i]->heightMm; });
  for (; at != byHeight_.end() &&
         planes_[*at]->heightMm < layer.heightMm - kNearest * layer.thicknessMm;
       ++at)
    if (boxes_[*at].touches(box) && planes_[*at]->direction.isApprox(layer.direction))
      std::ranges::copy(planes_[*at]->contours(), std::back_inserter(all));
  return geometry::united(all);
}

} // namespace voluta::toolpath
