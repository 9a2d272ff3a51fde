#include "curved/decompose.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "curved/convex_front.h"
#include "curved/field_fit.h"
#include "curved/flood.h"
#include "curved/forward_growth.h"
#include "curved/missed_voxels.h"
#include "curved/reverse_growth.h"
#include "curved/smooth_field.h"
#include "curved/voxel_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace voluta::curved {

namespace {

std::size_t cellOf(const VoxelGraph& graph, std::size_t v) {
  return graph.grid.index(graph.cell[v][0], graph.cell[v][1], graph.cell[v][2]);
}

// The front's normal for each voxel, hulls taken before each group of equal key.
template <typename Key>
std::vector<Eigen::Vector3f> frontNormals(const VoxelGraph& graph, const std::vector<Key>& key,
                                          const std::vector<Eigen::Vector3f>& wish,
                                          const base::RunContext& ctx) {
  std::vector<std::int32_t> order;
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (key[v] >= 0)
      order.push_back(static_cast<std::int32_t>(v));
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return key[static_cast<std::size_t>(a)] < key[static_cast<std::size_t>(b)];
  });
  std::vector<Eigen::Vector3f> normals(graph.size(), Eigen::Vector3f::Zero());
  ConvexFront front(graph);
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    const auto keyAt = [&](std::size_t i) { return key[static_cast<std::size_t>(order[i])]; };
    while (end < order.size() && keyAt(end) == keyAt(begin))
      ++end;
    base::parallelChunks(ctx, end - begin, 256, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = begin + from; i < begin + to; ++i) {
        const auto v = static_cast<std::size_t>(order[i]);
        normals[v] = front.clearNormal(v, wish[v].cast<double>()).cast<float>();
      }
    });
    for (std::size_t i = begin; i < end; ++i)
      front.insert(static_cast<std::size_t>(order[i]));
    front.rebuild();
    begin = end;
  }
  return normals;
}

void store(const VoxelGraph& graph, const std::vector<std::int32_t>& rank,
           const std::vector<Eigen::Vector3f>& normals, Decomposition& out) {
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (rank[v] > 0) {
      out.rank[cellOf(graph, v)] = rank[v];
      out.frontNormal[cellOf(graph, v)] = normals[v];
    }
}

void growGreedy(const VoxelGraph& graph, Decomposition& out, const base::RunContext& ctx) {
  base::Stopwatch watch;
  const ForwardGrowth grown = forwardGrowth(graph, ForwardScheme::Greedy, {}, ctx.sub(0.0, 0.7));
  std::vector<std::int32_t> key(graph.size());
  std::vector<float> height(graph.size());
  for (std::size_t v = 0; v < graph.size(); ++v) {
    key[v] = grown.rank[v] > 0 ? grown.rank[v] : -1;
    height[v] = static_cast<float>(grown.rank[v]);
  }
  const std::vector<Eigen::Vector3f> wish = fieldGradient(graph, height, ctx);
  store(graph, grown.rank, frontNormals(graph, key, wish, ctx), out);
  out.layers = grown.ranks;
  out.seconds.grow = watch.seconds();
}

// The order that misses fewest voxels. Strict accessibility first; where that loses some, half a
// voxel of tolerance at stuck moments, then another sheet: none is best for every part.
Peeling plainOrder(const VoxelGraph& graph, const base::RunContext& ctx) {
  Peeling best;
  std::size_t bestLaid = 0;
  double done = 0.0;
  constexpr std::array<std::array<double, 2>, 3> kSheetAndStuck{
      {{0.6, 0.0}, {0.6, 0.5}, {1.0, 0.5}}};
  for (const auto& [sheet, stuckTolerance] : kSheetAndStuck) {
    PeelOptions options;
    options.sheet = sheet;
    options.stuckTolerance = stuckTolerance;
    Peeling result = peelAll(graph, {}, {}, options, ctx.sub(done, done + 0.3));
    done += 0.3;
    const auto laid = static_cast<std::size_t>(
        std::count_if(result.rank.begin(), result.rank.end(), [](int r) { return r > 0; }));
    if (best.rank.empty() || laid > bestLaid) {
      best = std::move(result);
      bestLaid = laid;
    }
    if (best.givenUp == 0)
      break;
  }
  return best;
}

void growReverse(const VoxelGraph& graph, const CurvedOptions& options, Decomposition& out,
                 const base::RunContext& ctx) {
  base::Stopwatch watch;
  // What can be laid at all, and an order that is there in any case.
  const Peeling plain = plainOrder(graph, ctx.sub(0.0, 0.15));
  std::vector<std::uint8_t> use(out.grid.cellCount(), 0);
  for (std::size_t v = 0; v < graph.size(); ++v)
    use[cellOf(graph, v)] = plain.rank[v] > 0;
  out.seconds.peel = watch.seconds();

  const VoxelGraph laid = voxelGraph(out.grid, use, graph.plateLayer, out.platform);
  const LayerLimits limits{options.layerHeightMm, options.heightMinMm, options.heightMaxMm};
  const SmoothField smooth = smoothField(laid, limits, options.rounds, ctx.sub(0.15, 0.85));
  out.seconds.smooth = smooth.smoothSeconds;
  out.seconds.grow = smooth.growSeconds;

  base::Stopwatch growing;
  std::vector<float> guide(laid.size());
  for (std::size_t v = 0; v < laid.size(); ++v)
    guide[v] = static_cast<float>(smooth.field[v] / out.grid.pitch);
  PeelOptions strict;
  strict.sacrifice = false;
  strict.levelStep = 1.0;
  Peeling guided = peel(laid, {}, guide, strict, ctx.sub(0.85, 0.95));
  std::vector<std::int32_t> rank = std::move(guided.rank);
  out.layers = guided.ranks;
  std::size_t relaxed = guided.relaxed;
  if (guided.remaining > 0 || guided.relaxed > plain.relaxed) {
    relaxed = plain.relaxed;
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (plain.rank[v] > 0)
        rank[static_cast<std::size_t>(laid.voxelAt[cellOf(graph, v)])] = plain.rank[v];
    out.layers = plain.ranks;
  }
  out.epsilonMm = relaxed > 0 ? strict.stuckTolerance * out.grid.pitch : 0.0;

  ctx.report(0.95, "growth");
  std::vector<std::int32_t> level(laid.size());
  for (std::size_t v = 0; v < laid.size(); ++v)
    level[v] = static_cast<std::int32_t>(
        std::floor(static_cast<double>(smooth.field[v]) / options.layerHeightMm));
  const std::vector<Eigen::Vector3f> wish = fieldGradient(laid, smooth.field, ctx);
  store(laid, rank, frontNormals(laid, level, wish, ctx), out);
  out.field.assign(out.grid.cellCount(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t v = 0; v < laid.size(); ++v)
    out.field[cellOf(laid, v)] = smooth.field[v];
  out.seconds.grow += growing.seconds();
}

} // namespace

std::vector<std::string> growthSchemes() {
  return {"auto", "reverse", "greedy"};
}

base::ParameterTable curvedParameters() {
  return base::ParameterTable({
      base::numberParameter("voxelMm", "mm", 0.8, 0.1, 10.0, "Layers", "Voxel width",
                            "Width of the voxels that growth works on; layers are not bound to it.",
                            true),
      base::integerParameter("fieldRounds", 4, 1, 30, "Layers", "Field rounds",
                             "How often growth and smooth field are fitted to each other."),
  });
}

Decomposition decompose(const voxel::SolidVoxels& voxels,
                        const std::vector<Eigen::Vector2d>& platform, const CurvedOptions& options,
                        const base::RunContext& ctx) {
  const std::vector<std::string> schemes = growthSchemes();
  if (std::find(schemes.begin(), schemes.end(), options.growth) == schemes.end())
    throw base::Error(base::ErrorCode::Usage, "unknown growth '" + options.growth + "'", "growth",
                      "did you mean " + base::nearestName(options.growth, schemes) + "?");
  base::require(options.rounds >= 1 && options.heightMinMm > 0.0 &&
                    options.heightMinMm <= options.layerHeightMm &&
                    options.layerHeightMm <= options.heightMaxMm,
                "decompose: rounds >= 1, 0 < heightMin <= layerHeight <= heightMax");
  const VoxelGraph graph = voxelGraph(voxels.grid, voxels.solid, voxels.plateLayer(), platform);
  if (std::find(graph.onPlatform.begin(), graph.onPlatform.end(), 1) == graph.onPlatform.end())
    throw base::Error(base::ErrorCode::UnusableInput, "the part does not touch the platform", {},
                      "drop it to the plate or choose a platform under it");

  Decomposition out;
  out.grid = voxels.grid;
  out.platform = platform;
  out.growth = options.growth == "auto" ? "reverse" : options.growth;
  out.voxels = voxels.count;
  out.rank.assign(voxels.grid.cellCount(), 0);
  for (std::size_t c = 0; c < out.rank.size(); ++c)
    out.rank[c] = voxels.solid[c] ? -1 : 0;
  out.frontNormal.assign(voxels.grid.cellCount(), Eigen::Vector3f::Zero());
  if (out.growth == "greedy")
    growGreedy(graph, out, ctx);
  else
    growReverse(graph, options, out, ctx);
  describeMissed(voxels, out, ctx);
  ctx.report(1.0, "growth");
  return out;
}

} // namespace voluta::curved
