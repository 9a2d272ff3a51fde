#include "curved/decompose.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "curved/coarse_field.h"
#include "curved/convex_front.h"
#include "curved/field_fit.h"
#include "curved/flood.h"
#include "curved/grow.h"
#include "curved/missed_voxels.h"
#include "curved/nozzle_reach.h"
#include "curved/reverse_growth.h"
#include "curved/smooth_field.h"
#include "curved/voxel_graph.h"
#include "curved/voxels_by_level.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

namespace voluta::curved {

namespace {

// Returns the front's normal for each voxel, with the hull of all groups of smaller key. If there
// is a head, voxels deeper than half a cell inside the hull get a direction in which that head
// clears all previous groups; they are marked in `byHead`.
std::vector<Eigen::Vector3f>
frontNormals(const VoxelGraph& graph, const std::vector<std::int32_t>& key,
             const std::vector<Eigen::Vector3f>& wish, const process::HeadShape* head,
             std::vector<std::uint8_t>& byHead, const base::RunContext& ctx) {
  const VoxelsByLevel byKey(key);
  std::vector<Eigen::Vector3f> normals(graph.size(), Eigen::Vector3f::Zero());
  byHead.assign(graph.size(), 0);
  ConvexFront front(graph, ConvexFront::Columns::None);
  std::optional<NozzleReach> reach;
  if (head != nullptr)
    reach.emplace(graph, *head);
  for (std::size_t group = 0; group < byKey.levels(); ++group) {
    const std::span<const std::int32_t> voxels = byKey.of(group);
    base::parallelChunks(ctx, voxels.size(), 256, [&](std::size_t begin, std::size_t end) {
      std::size_t hint = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const auto v = static_cast<std::size_t>(voxels[i]);
        const Eigen::Vector3d wished = wish[v].cast<double>();
        std::optional<Eigen::Vector3d> direction;
        if (reach && front.deeperThan(v, 0.5, hint))
          direction = reach->direction(v, wished);
        byHead[v] = direction.has_value();
        normals[v] = (direction ? *direction : front.clearNormal(v, wished)).cast<float>();
      }
    });
    for (const std::int32_t v : voxels) {
      front.insert(static_cast<std::size_t>(v));
      if (reach)
        reach->insert(static_cast<std::size_t>(v));
    }
    front.rebuild();
  }
  return normals;
}

void store(const VoxelGraph& graph, const std::vector<std::int32_t>& rank,
           const std::vector<Eigen::Vector3f>& normals, Decomposition& out) {
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (rank[v] > 0) {
      out.rank[graph.cellOf(v)] = rank[v];
      out.frontNormal[graph.cellOf(v)] = normals[v];
    }
}

// Returns the front normals for ranks without a field.
std::vector<Eigen::Vector3f> normalsOfRanks(const VoxelGraph& graph,
                                            const std::vector<std::int32_t>& rank,
                                            const base::RunContext& ctx) {
  std::vector<std::int32_t> key(graph.size());
  std::vector<float> height(graph.size());
  for (std::size_t v = 0; v < graph.size(); ++v) {
    key[v] = rank[v] > 0 ? rank[v] : -1;
    height[v] = static_cast<float>(rank[v]);
  }
  std::vector<std::uint8_t> none;
  return frontNormals(graph, key, fieldGradient(graph, height, ctx), nullptr, none, ctx);
}

void storeField(const VoxelGraph& graph, const std::vector<float>& field, Decomposition& out) {
  out.field.assign(out.grid.cellCount(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t v = 0; v < graph.size(); ++v)
    out.field[graph.cellOf(v)] = field[v];
}

// Computes the field of the printed voxels, and ranks that follow it.
void fitField(const VoxelGraph& graph, const Growth& growth, const CurvedOptions& options,
              Decomposition& out, const DecompositionWatch& watch, const base::RunContext& ctx) {
  base::Stopwatch clock;
  std::optional<VoxelGraph> withoutMissed;
  if (growth.printed < graph.size()) {
    std::vector<std::uint8_t> use(out.grid.cellCount(), 0);
    for (std::size_t v = 0; v < graph.size(); ++v)
      use[graph.cellOf(v)] = growth.rank[v] > 0;
    withoutMissed = voxelGraph(out.grid, use, graph.plateLayer, out.platform);
  }
  const VoxelGraph& printed = withoutMissed ? *withoutMissed : graph;
  const LayerLimits limits{options.layerHeightMm, options.heightMinMm, options.heightMaxMm};
  const auto improved = [&](const std::vector<float>& field) {
    if (!watch)
      return;
    storeField(printed, field, out);
    watch(out);
  };
  std::vector<std::int32_t> plain(printed.size());
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (growth.rank[v] > 0)
      plain[static_cast<std::size_t>(printed.voxelAt[graph.cellOf(v)])] = growth.rank[v];
  const process::HeadShape* const head = options.head.sections.empty() ? nullptr : &options.head;
  const bool coarse = printed.size() > kFieldVoxels;
  const std::vector<float> field =
      coarse
          ? coarseField(printed, out.platform, limits, options.rounds, head, ctx.sub(0.0, 0.85))
          : smoothField(printed, plain, limits, options.rounds, head, improved, ctx.sub(0.0, 0.85))
                .field;

  std::vector<std::int32_t> rank = std::move(plain);
  if (!coarse) {
    std::vector<float> guide(printed.size());
    for (std::size_t v = 0; v < printed.size(); ++v)
      guide[v] = static_cast<float>(field[v] / out.grid.pitch);
    PeelOptions strict;
    strict.levelStep = 1.0;
    strict.sacrifice = false;
    Peeling guided = peelGuided(printed, guide, rank, strict, ctx.sub(0.85, 0.95));
    if (guided.remaining == 0 && guided.relaxed <= growth.relaxed) {
      rank = std::move(guided.rank);
      out.layers = guided.ranks;
      out.epsilonMm = guided.deepest * out.grid.pitch;
    }
  }

  ctx.report(0.95, "front"_text);
  std::vector<std::int32_t> level(printed.size());
  for (std::size_t v = 0; v < printed.size(); ++v)
    level[v] = static_cast<std::int32_t>(
        std::floor(static_cast<double>(field[v]) / options.layerHeightMm));
  const std::vector<Eigen::Vector3f> wish = fieldGradient(printed, field, ctx);
  std::vector<std::uint8_t> byHead;
  store(printed, rank, frontNormals(printed, level, wish, head, byHead, ctx), out);
  storeField(printed, field, out);
  if (std::find(byHead.begin(), byHead.end(), 1) != byHead.end())
    out.byHead.resize(out.grid.cellCount(), 0);
  for (std::size_t v = 0; v < printed.size(); ++v)
    if (byHead[v])
      out.byHead[printed.cellOf(v)] = 2;
  out.seconds.smooth = clock.seconds();
}

} // namespace

const process::HeadShape* headForLosses(const CurvedOptions& options) {
  return options.headForLosses && !options.head.sections.empty() ? &options.head : nullptr;
}

base::ParameterTable curvedParameters() {
  return base::ParameterTable({
      base::numberParameter(
          "voxelMm", "mm", 0.8, 0.1, 100.0, "Layers"_text, "Voxel width"_text,
          "Voxel width used for growth; the layer height is independent of it."_text, true),
      base::choiceParameter(
          "frontShape", "auto",
          {{"auto", "auto"_text}, {"flat", "flat"_text}, {"nozzle", "nozzle"_text}}, "Layers"_text,
          "Front"_text,
          "Head shape that must clear the part printed so far. flat: a plate of unlimited width. "
          "nozzle: the real head where voxels would be lost otherwise, and under wide roofs. "
          "auto: the real head only under wide roofs."_text),
      base::integerParameter("fieldRounds", 8, 0, 30, "Layers"_text, "Field rounds"_text,
                             "Maximum number of rounds that fit the growth order and the smooth "
                             "field to each other. 0: layers follow the growth order."_text),
  });
}

Decomposition decompose(const voxel::SolidVoxels& voxels,
                        const std::vector<Eigen::Vector2d>& platform, const CurvedOptions& options,
                        const base::RunContext& ctx, const DecompositionWatch& watch,
                        const DecompositionFilter& isRejected,
                        std::shared_ptr<const Growth> known) {
  base::require(options.rounds >= 0 && options.heightMinMm > 0.0 &&
                    options.heightMinMm <= options.layerHeightMm &&
                    options.layerHeightMm <= options.heightMaxMm,
                "decompose: rounds >= 0, 0 < heightMin <= layerHeight <= heightMax");
  const VoxelGraph graph = voxelGraph(voxels.grid, voxels.solid, voxels.plateLayer(), platform);
  if (std::find(graph.onPlatform.begin(), graph.onPlatform.end(), 1) == graph.onPlatform.end())
    throw base::Error(base::ErrorCode::UnusableInput, "the part does not touch the platform"_text,
                      {}, "drop it to the plate, or choose a platform below it"_text);

  Decomposition out;
  out.grid = voxels.grid;
  out.platform = platform;
  out.voxels = voxels.count;
  out.rank.assign(voxels.grid.cellCount(), 0);
  for (std::size_t c = 0; c < out.rank.size(); ++c)
    out.rank[c] = voxels.solid[c] ? -1 : 0;
  out.frontNormal.assign(voxels.grid.cellCount(), Eigen::Vector3f::Zero());

  const bool fits = options.growth.row().peels && options.rounds > 0;
  if (!known) {
    known = std::make_shared<Growth>(grow(graph, options.growth, options.forward,
                                          ctx.sub(0.0, fits ? 0.15 : 0.9), headForLosses(options)));
    out.seconds.peel = known->peelSeconds;
    out.seconds.grow = known->growSeconds;
  }
  const Growth& growth = *known;
  out.growth = growth.scheme;
  out.layers = growth.ranks;
  if (growth.byHead > 0)
    out.byHead.assign(voxels.grid.cellCount(), 0);
  out.epsilonMm = growth.epsilon * out.grid.pitch;
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (growth.rank[v] > 0)
      out.rank[graph.cellOf(v)] = growth.rank[v];
  describeMissed(voxels, out, ctx);
  if (watch)
    watch(out);
  if (isRejected && isRejected(out.findings))
    return out;
  if (fits && growth.printed > 0)
    fitField(graph, growth, options, out, watch, ctx.sub(0.15, 1.0));
  else
    store(graph, growth.rank, normalsOfRanks(graph, growth.rank, ctx), out);
  if (growth.byHead > 0)
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (growth.headDirection[v] != Eigen::Vector3f::Zero()) {
        out.frontNormal[graph.cellOf(v)] = growth.headDirection[v];
        out.byHead[graph.cellOf(v)] = 1;
      }
  out.headVoxels = static_cast<std::size_t>(
      std::count_if(out.byHead.begin(), out.byHead.end(), [](std::uint8_t b) { return b != 0; }));
  ctx.report(1.0, "growth"_text);
  return out;
}

} // namespace voluta::curved
