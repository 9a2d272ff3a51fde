#include "layers/islands.h"

#include "geometry/measures.h"
#include "layers/order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace voluta::layers {

namespace {

// An island on an island is found in the next round; deeper stacks are no longer small.
constexpr int kRounds = 6;
// Patches that rest on a patch are at most this far from it.
constexpr double kNearMm = 3.0;

} // namespace

IslandOptions islandOptions(double beadWidthMm) {
  constexpr double kBeadsToDrop = 4.0;
  IslandOptions options;
  options.dropMm2 = std::pow(kBeadsToDrop * beadWidthMm, 2);
  return options;
}

AbsorbedIslands absorbIslands(LayerStack& stack, const IslandOptions& options,
                              const AbsorbOptions& absorb, const base::RunContext& ctx,
                              const Ground& ground) {
  AbsorbedIslands result;
  result.support = checkSupport(stack, options.supportReach, ctx, {}, ground);
  bool isChanged = false;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Eigen::AlignedBox3d> removedBoxes;
    for (std::size_t p = 0; p < stack.patches.size(); ++p) {
      if (stack.patches[p].group == kSupportGroup ||
          result.support[p].supportedFraction >= options.supportedShare)
        continue;
      ctx.checkpoint();
      AbsorbOptions with = absorb;
      if (geometry::area(stack.patches[p].surface) > options.dropMm2)
        with.minShare = std::max(absorb.minShare, options.minMergedShare);
      // Patches of the same layer do not absorb, so the patch may stay in the stack meanwhile.
      Absorbed one = absorbSlivers(stack.patches, {stack.patches[p]}, with);
      if (one.refused > 0)
        continue;
      removedBoxes.push_back(geometry::bounds(stack.patches[p].surface));
      removedBoxes.back().min().array() -= kNearMm;
      removedBoxes.back().max().array() += kNearMm;
      stack.patches.erase(stack.patches.begin() + static_cast<std::ptrdiff_t>(p));
      result.support.erase(result.support.begin() + static_cast<std::ptrdiff_t>(p));
      --p;
      result.absorbed.merged += one.merged;
      result.absorbed.mergedVolumeMm3 += one.mergedVolumeMm3;
      std::move(one.dropped.begin(), one.dropped.end(),
                std::back_inserter(result.absorbed.dropped));
    }
    if (removedBoxes.empty())
      break;
    isChanged = true;
    std::vector<std::size_t> which;
    for (std::size_t p = 0; p < stack.patches.size(); ++p) {
      const Eigen::AlignedBox3d box = geometry::bounds(stack.patches[p].surface);
      if (std::any_of(removedBoxes.begin(), removedBoxes.end(),
                      [&](const Eigen::AlignedBox3d& b) { return b.intersects(box); }))
        which.push_back(p);
    }
    if (which.empty())
      break;
    const std::vector<SupportCheck> again =
        checkSupport(stack, options.supportReach, ctx, which, ground);
    for (std::size_t n = 0; n < which.size(); ++n)
      result.support[which[n]] = again[n];
  }
  if (isChanged)
    numberLayers(stack);
  return result;
}

} // namespace voluta::layers
