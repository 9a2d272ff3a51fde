#include "curved/grow.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "curved/reverse_growth.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace voluta::curved {

namespace {

struct ForwardRow {
  const char* id;
  ForwardScheme scheme;
};
constexpr std::array<ForwardRow, 4> kForward{{{"guided", ForwardScheme::Guided},
                                              {"adaptive", ForwardScheme::Adaptive},
                                              {"incremental", ForwardScheme::Incremental},
                                              {"greedy", ForwardScheme::Greedy}}};

// Of so many voxels, so small a share missed is not worth minutes of further passes.
constexpr std::size_t kManyVoxels = 200'000;
constexpr double kFewMissed = 1e-4;

std::size_t laidOf(const std::vector<std::int32_t>& rank) {
  return static_cast<std::size_t>(
      std::count_if(rank.begin(), rank.end(), [](std::int32_t r) { return r > 0; }));
}

void growReverse(const VoxelGraph& graph, const process::HeadShape* head, Growth& out,
                 const base::RunContext& ctx) {
  base::Stopwatch watch;
  PeelOptions first;
  first.head = head;
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
        options.head = head;
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
}

} // namespace

std::vector<std::string> growthSchemes() {
  std::vector<std::string> ids{"auto", "reverse"};
  for (const ForwardRow& row : kForward)
    ids.emplace_back(row.id);
  return ids;
}

bool peels(const std::string& scheme) {
  return scheme == "auto" || scheme == "reverse";
}

void checkGrowthScheme(const std::string& scheme) {
  const std::vector<std::string> ids = growthSchemes();
  if (std::find(ids.begin(), ids.end(), scheme) == ids.end())
    throw base::Error(base::ErrorCode::Usage, "unknown growth '" + scheme + "'", "growth",
                      "did you mean " + base::nearestName(scheme, ids) + "?");
}

Growth grow(const VoxelGraph& graph, const std::string& scheme, const ForwardOptions& forward,
            const base::RunContext& ctx, const process::HeadShape* head) {
  checkGrowthScheme(scheme);
  Growth out;
  const auto* const row = std::find_if(kForward.begin(), kForward.end(),
                                       [&](const ForwardRow& r) { return scheme == r.id; });
  if (row == kForward.end()) {
    growReverse(graph, head, out, ctx);
  } else {
    base::Stopwatch watch;
    ForwardGrowth grown = forwardGrowth(graph, row->scheme, forward, ctx);
    out.growSeconds = watch.seconds();
    out.scheme = scheme;
    out.rank = std::move(grown.rank);
    out.ranks = grown.ranks;
  }
  out.laid = laidOf(out.rank);
  return out;
}

} // namespace voluta::curved
