#include "collision/same_segments.h"

#include "base/parallel.h"
#include "base/run_context.h"

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

namespace voluta::collision {

namespace {

constexpr std::size_t kGrain = 4096;

bool sameWaypoint(const plan::ToolPlan& a, std::size_t i, const plan::ToolPlan& b, std::size_t j) {
  return a.position[i] == b.position[j] && a.direction[i] == b.direction[j] &&
         a.widthMm[i] == b.widthMm[j] && a.heightMm[i] == b.heightMm[j];
}

bool same(const plan::ToolPlan& a, std::uint32_t s, const plan::ToolPlan& b, std::uint32_t t) {
  return sameWaypoint(a, s, b, t) && sameWaypoint(a, s + std::size_t{1}, b, t + std::size_t{1});
}

// Hash of its start and end.
std::uint64_t hashOf(const plan::ToolPlan& plan, std::uint32_t segment) {
  std::uint64_t hash = 0;
  for (const std::size_t i : {std::size_t{segment}, segment + std::size_t{1}})
    for (const double x : plan.position[i]) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
  return hash;
}

} // namespace

std::vector<std::uint32_t> sameSegments(const plan::ToolPlan& plan,
                                        const std::vector<std::uint32_t>& of,
                                        const plan::ToolPlan& itsPlan,
                                        const std::vector<std::uint32_t>& its,
                                        const base::RunContext& ctx) {
  using Named = std::pair<std::uint64_t, std::uint32_t>; // by its hash, an index in `of`
  std::vector<Named> named;
  const auto find = [&](std::uint32_t segment, std::size_t from) {
    if (named.empty() && !of.empty()) {
      named.resize(of.size());
      base::parallelChunks(ctx, of.size(), kGrain, [&](std::size_t b, std::size_t e) {
        for (std::size_t i = b; i < e; ++i)
          named[i] = {hashOf(plan, of[i]), static_cast<std::uint32_t>(i)};
      });
      std::ranges::sort(named);
    }
    const std::uint64_t hash = hashOf(itsPlan, segment);
    auto at = std::ranges::lower_bound(named, Named(hash, static_cast<std::uint32_t>(from)));
    while (at != named.end() && at->first == hash && !same(plan, of[at->second], itsPlan, segment))
      ++at;
    return at != named.end() && at->first == hash ? at->second : kNoSegment;
  };
  std::vector<std::uint32_t> found(its.size(), kNoSegment);
  std::size_t next = 0;
  for (std::size_t i = 0; i < its.size(); ++i) {
    if (i % kGrain == 0)
      ctx.checkpoint();
    const bool follows = next < of.size() && same(plan, of[next], itsPlan, its[i]);
    found[i] = follows ? static_cast<std::uint32_t>(next) : find(its[i], next);
    if (found[i] != kNoSegment)
      next = found[i] + std::size_t{1};
  }
  return found;
}

} // namespace voluta::collision
