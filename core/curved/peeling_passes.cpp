#include "curved/peeling_passes.h"

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "curved/reverse_growth.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace voluta::curved {

namespace {
// For this many voxels, a missed share this small is not worth minutes of further passes.
constexpr std::size_t kManyVoxels = 200'000;
constexpr double kFewMissed = 1e-4;
} // namespace

Growth growByPeeling(const GrowthInput& in, const base::RunContext& ctx) {
  const VoxelGraph& graph = in.graph;
  base::Stopwatch watch;
  Growth out;
  PeelOptions first;
  first.head = in.head;
  first.runs = 1;
  Peeling best = peelAll(graph, {}, first, ctx.sub(0.0, 0.5));
  out.peelSeconds = watch.seconds();
  const bool enough = best.abandoned == 0 || (graph.size() > kManyVoxels &&
                                              static_cast<double>(best.abandoned) <=
                                                  kFewMissed * static_cast<double>(graph.size()));
  if (!enough) {
    struct Pass {
      double sheet;
      bool relaxSheets;
    };
    constexpr std::array<Pass, 2> kPasses{{{0.6, true}, {1.0, true}}};
    std::array<Peeling, kPasses.size()> passes;
    base::parallelChunks(ctx, kPasses.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        PeelOptions options;
        options.sheet = kPasses[p].sheet;
        options.relaxSheets = kPasses[p].relaxSheets;
        options.head = in.head;
        passes[p] = peelAll(graph, {}, options, ctx.quiet());
      }
    });
    const auto key = [](const Peeling& p) { return std::tuple(p.abandoned, p.relaxed, p.ranks); };
    best = std::move(
        *std::min_element(passes.begin(), passes.end(),
                          [&](const Peeling& a, const Peeling& b) { return key(a) < key(b); }));
    out.growSeconds = watch.seconds() - out.peelSeconds;
  }
  out.scheme = "reverse";
  out.rank = std::move(best.rank);
  out.ranks = best.ranks;
  out.relaxed = best.relaxed;
  out.epsilon = best.deepest;
  out.headDirection = std::move(best.headDirection);
  out.byHead = best.byHead;
  return out;
}

} // namespace voluta::curved
