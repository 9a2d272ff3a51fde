#include "curved/curved_layers.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "curved/extraction.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "layers/absorb.h"
#include "layers/clean_surface.h"
#include "layers/follow_top.h"
#include "layers/islands.h"
#include "layers/layer_findings.h"
#include "layers/order.h"
#include "layers/part_boundary.h"
#include "layers/patches.h"
#include "layers/trim.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace voluta::curved {

namespace {

// Edges of a raw level shorter than this share of the pitch are collapsed, before and after
// trimming.
constexpr double kShortRaw = 0.3, kShortTrimmed = 0.2;
// Partial levels are used where the affected volume is that of a patch with edges of this many bead
// widths.
constexpr double kBeadsToChange = 2.0;
// Minimum volume of a change, in voxels. Half of them may be outside the part; with fewer, the seam
// would have only one side.
constexpr double kVoxelsToChange = 60.0;
// Scale of the height changes of a last layer, as a share of the bead width.
constexpr double kFineShare = 1.0 / 6.0;
constexpr double kTunedWidthMm = 1.2; // bead width that tolerances were tuned for

// Returns the spacing near `wanted` that divides the part's highest level evenly.
double fittedSpacing(const LevelField& field, const geometry::TriangleMesh& part, double wanted) {
  double top = 0.0;
  for (const Eigen::Vector3d& v : part.vertices)
    if (const std::optional<double> level = field.valueAt(v))
      top = std::max(top, *level);
  if (top < 0.5 * wanted)
    return wanted;
  return top / std::max(1.0, std::round(top / wanted));
}

// Returns for each cell the component of printed voxels (26 neighbours) that it belongs to, -1
// elsewhere.
std::vector<int> componentsOf(const Decomposition& d, const base::RunContext& ctx) {
  std::vector<int> of(d.grid.cellCount(), -1);
  std::vector<std::size_t> front;
  int count = 0;
  for (std::size_t seed = 0; seed < of.size(); ++seed) {
    if (d.rank[seed] <= 0 || of[seed] >= 0)
      continue;
    of[seed] = count;
    front.assign(1, seed);
    for (std::size_t done = 0; !front.empty(); ++done) {
      if (done % 65536 == 0)
        ctx.checkpoint();
      const Eigen::Vector3i c = d.grid.cell(front.back());
      front.pop_back();
      for (int n = 0; n < 27; ++n) {
        const int i = c.x() + n % 3 - 1, j = c.y() + n / 3 % 3 - 1, k = c.z() + n / 9 - 1;
        if (!d.grid.contains(i, j, k))
          continue;
        const std::size_t u = d.grid.index(i, j, k);
        if (d.rank[u] > 0 && of[u] < 0) {
          of[u] = count;
          front.push_back(u);
        }
      }
    }
    ++count;
  }
  return of;
}

int groupOf(const layers::Patch& patch, const Decomposition& d, const std::vector<int>& component) {
  for (const Eigen::Vector3d& v : patch.surface.vertices) {
    const Eigen::Vector3i c = d.grid.cellOf(v);
    if (!d.grid.contains(c.x(), c.y(), c.z()))
      continue;
    const int group = component[d.grid.index(c.x(), c.y(), c.z())];
    if (group >= 0)
      return group;
  }
  return 0;
}

// Returns the maximum distance of boundary vertices from the part's surface, without inner rims.
double farthestOf(const layers::PatchesOfLevel& level, const geometry::MeshQuery& part) {
  double farthest = 0.0;
  for (std::size_t p = 0; p < level.patches.size(); ++p) {
    const auto& mesh = level.patches[p].surface;
    const auto edges = geometry::sortedHalfEdges(mesh);
    std::vector<std::uint8_t> isDone = level.patches[p].innerRim;
    isDone.resize(mesh.vertices.size(), 0);
    geometry::forEachEdge(edges, [&](std::size_t b, std::size_t e) {
      if (e - b != 1)
        return;
      for (int v : {edges[b].low, edges[b].high}) {
        if (isDone[static_cast<std::size_t>(v)]++ == 0)
          farthest =
              std::max(farthest, part.closest(mesh.vertices[static_cast<std::size_t>(v)]).distance);
      }
    });
  }
  return farthest;
}

void reportDropped(LayersResult& result, const std::vector<layers::DroppedPiece>& dropped) {
  const layers::DroppedPiece* largest = nullptr;
  for (const layers::DroppedPiece& piece : dropped) {
    ++result.droppedPieces;
    result.droppedVolumeMm3 += piece.volumeMm3;
    if (largest == nullptr || piece.volumeMm3 > largest->volumeMm3)
      largest = &piece;
  }
  if (largest == nullptr)
    return;
  result.findings.push_back(plan::makeFinding(plan::FindingKind::DroppedPieces,
                                              {{"pieces", dropped.size()},
                                               {"volume", base::mm3(result.droppedVolumeMm3)},
                                               {"largest", base::mm3(largest->volumeMm3)}},
                                              largest->centre, dropped.size()));
}

void reportUnsupported(LayersResult& result, const std::vector<layers::SupportCheck>& support,
                       const layers::IslandOptions& islands) {
  const layers::SupportCheck* first = nullptr;
  double area = 0.0, loose = 0.0, whole = 0.0;
  for (std::size_t p = 0; p < support.size(); ++p) {
    const double patch = geometry::area(result.stack.patches[p].surface);
    whole += patch;
    loose += (1.0 - support[p].supportedFraction) * patch;
    if (support[p].supportedFraction >= islands.supportedShare)
      continue;
    ++result.unsupportedPatches;
    area += patch;
    if (first == nullptr)
      first = &support[p];
  }
  result.unsupportedFraction = whole > 0.0 ? loose / whole : 0.0;
  if (first == nullptr)
    return;
  result.findings.push_back(
      plan::makeFinding(plan::FindingKind::UnsupportedPatches,
                        {{"patches", result.unsupportedPatches}, {"area", base::mm2(area)}},
                        first->unsupportedAt, result.unsupportedPatches));
}

} // namespace

LayersResult curvedLayers(const Decomposition& d, const geometry::TriangleMesh& part,
                          const LayerOptions& o, const base::RunContext& ctx,
                          std::vector<SupportPatch> supports) {
  base::require(o.layerHeightMm > 0.0 && o.heightMinMm > 0.0 && o.heightMinMm <= o.heightMaxMm &&
                    o.beadWidthMm > 0.0,
                "positive layer heights and bead width");
  LayersResult result;
  base::Stopwatch extractClock;
  ctx.report(0.0, "cutting layers from the field"_text);
  const LevelField field(d, ctx);
  result.spacingMm = o.fitSpacing ? fittedSpacing(field, part, o.layerHeightMm) : o.layerHeightMm;
  const double side = kBeadsToChange * o.beadWidthMm;
  const PartialLevels partial(
      field,
      {result.spacingMm, o.heightMinMm, o.heightMaxMm,
       std::max(side * side * result.spacingMm, kVoxelsToChange * std::pow(d.grid.pitch, 3))},
      ctx);
  std::vector<RawSlab> levels = extractSlabs(field, partial, ctx);
  result.seconds.extract = extractClock.seconds();

  base::Stopwatch trimClock;
  ctx.report(0.3, "trimming layers on the part"_text);
  const layers::PartBoundary boundary(part, d.grid.pitch, ctx);
  const std::vector<int> component = componentsOf(d, ctx);
  std::vector<layers::PatchesOfLevel> patches(levels.size());
  std::vector<double> farthest(levels.size(), 0.0);
  // Tolerances grow with beads that are wider than those that they were tuned for.
  const double wider = std::max(1.0, o.beadWidthMm / kTunedWidthMm);
  layers::TrimOptions trim;
  trim.chordMm *= wider;
  base::parallelChunks(ctx, levels.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t l = begin; l < end; ++l) {
      layers::CleanOptions clean;
      clean.boundaryToleranceMm *= wider;
      clean.shortEdgeMm = kShortRaw * d.grid.pitch;
      RawLevel surface = std::move(levels[l].surface);
      layers::cleanSurface(surface, clean, ctx);
      surface = layers::trimToPart(surface, boundary, trim, ctx);
      clean.shortEdgeMm = kShortTrimmed * d.grid.pitch;
      layers::cleanSurface(surface, clean, ctx);
      patches[l] = layers::makePatches(surface, {o.beadWidthMm});
      farthest[l] = farthestOf(patches[l], boundary.query());
    }
  });
  std::vector<layers::Patch> slivers;
  for (std::size_t l = 0; l < patches.size(); ++l) {
    result.boundaryFarthestMm = std::max(result.boundaryFarthestMm, farthest[l]);
    std::move(patches[l].slivers.begin(), patches[l].slivers.end(), std::back_inserter(slivers));
    for (layers::Patch& p : patches[l].patches) {
      p.group = groupOf(p, d, component);
      if (levels[l].slab.scale != 0) {
        ++result.partialPatches;
        result.partialAreaMm2 += geometry::area(p.surface);
      }
      result.stack.patches.push_back(std::move(p));
    }
  }
  const layers::AbsorbOptions absorb{o.heightMaxMm, o.beadWidthMm};
  layers::Absorbed absorbed = layers::absorbSlivers(result.stack.patches, slivers, absorb);
  for (SupportPatch& support : supports) {
    support.patch.layer = static_cast<int>(
        std::floor(support.levelMm / partial.widthMm(PartialLevels::kFinest) + 1e-6));
    result.stack.patches.push_back(std::move(support.patch));
  }
  layers::orderForPrinting(result.stack);
  const layers::IslandOptions islands = layers::islandOptions(o.beadWidthMm);
  layers::AbsorbedIslands found = layers::absorbIslands(result.stack, islands, absorb, ctx);
  layers::Absorbed& absorbedIslands = found.absorbed;
  std::move(absorbedIslands.dropped.begin(), absorbedIslands.dropped.end(),
            std::back_inserter(absorbed.dropped));
  result.mergedPieces = absorbed.merged + absorbedIslands.merged;
  result.mergedVolumeMm3 = absorbed.mergedVolumeMm3 + absorbedIslands.mergedVolumeMm3;
  ctx.report(0.8, "ending layers on the surface"_text);
  layers::followTop(result.stack, boundary,
                    {o.heightMinMm, o.heightMaxMm, kFineShare * o.beadWidthMm}, ctx);
  ctx.report(0.9, "checking layers"_text);
  result.statistics = layers::layerStatistics(result.stack, {o.heightMinMm, o.heightMaxMm});
  result.volumeMm3 = result.statistics.volumeMm3();
  reportDropped(result, absorbed.dropped);
  reportUnsupported(result, found.support, islands);
  result.seconds.trim = trimClock.seconds();
  return result;
}

} // namespace voluta::curved
