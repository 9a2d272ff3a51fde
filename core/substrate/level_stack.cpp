#include "substrate/level_stack.h"

#include "base/error.h"
#include "base/parallel.h"
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
#include <iterator>
#include <utility>

namespace voluta::substrate {

namespace {

constexpr double kEdgeShare = 0.4; // Edges of levels, as a share of the bead width
constexpr double kGridShare = 1.4; // Grid cells, as a multiple of those edges
// Where last layers end on the surface, as a share of the bead width
constexpr double kFineShare = 0.17;
constexpr double kBlockingShare = 0.01; // Share of the volume that is not printed
// Share of a layer's height: a mid-surface this near to the ground belongs to the first layer.
constexpr double kOnGround = 0.75;

bool isOnGround(const layers::Patch& patch, const layers::Ground& ground) {
  for (std::size_t v = 0; v < patch.thicknessMm.size(); ++v)
    if (ground.over(patch.surface.vertices[v]) <= kOnGround * patch.thicknessMm[v])
      return true;
  return false;
}

void reportDropped(const std::vector<layers::DroppedPiece>& dropped, StackedLevels& result) {
  const layers::NotPrinted slivers = layers::notPrinted(dropped);
  result.slivers = slivers.pieces;
  result.sliverVolumeMm3 = slivers.volumeMm3;
  if (auto finding = layers::sliversFinding(slivers, result.statistics.volumeMm3(), kBlockingShare))
    result.findings.push_back(std::move(*finding));
}

void reportUnsupported(const layers::InAir& inAir, GroundKind ground, StackedLevels& result) {
  result.unsupportedPatches = inAir.patches;
  if (inAir.patches > 0)
    result.findings.push_back(
        plan::makeFinding(ground == GroundKind::Rod ? plan::FindingKind::BeginsInAirOverRod
                                                    : plan::FindingKind::BeginsInAirOverSurface,
                          {{"pieces", inAir.patches}}, inAir.firstAt, inAir.patches));
}

[[noreturn]] void missesGround(GroundKind ground) {
  if (ground == GroundKind::Rod)
    throw base::Error(base::ErrorCode::UnusableInput,
                      "the part misses the rod: no layer of it rests on the rod"_text, "rod"_text,
                      "move the part onto the rod"_text);
  throw base::Error(base::ErrorCode::UnusableInput,
                    "the part misses the surface: no layer of it rests on the surface"_text,
                    "surface"_text, "move the part onto the surface"_text);
}

// Reports the volume beyond the last level, where layers end before the part does.
void reportLeftOut(const geometry::TriangleMesh& part, StackedLevels& result) {
  const double whole = geometry::volume(part);
  const double missing = whole - result.statistics.volumeMm3() - result.sliverVolumeMm3;
  if (missing > kBlockingShare * whole)
    result.findings.push_back(plan::makeFinding(
        plan::FindingKind::NotPrinted, {{"left", base::mm3(missing)}, {"whole", base::mm3(whole)}},
        geometry::bounds(part).center()));
}

} // namespace

std::vector<double> levelBounds(double from, double to, const LevelOptions& o) {
  base::require(o.layerHeightMm > 0.0 && o.heightMinMm > 0.0 && o.heightMinMm <= o.heightMaxMm &&
                    o.firstLayerMm >= 0.0 && from < to,
                "positive layer heights and a range");
  std::vector<double> bounds{from};
  if (o.firstLayerMm > 0.0 && from + o.firstLayerMm < to) {
    from += o.firstLayerMm;
    bounds.push_back(from);
  }
  const double room = to - from;
  const int maximum = static_cast<int>(std::floor(room / o.heightMinMm + 1e-9)),
            minimum = static_cast<int>(std::ceil(room / o.heightMaxMm - 1e-9));
  const int wanted = static_cast<int>(std::lround(room / o.layerHeightMm));
  const int count = maximum >= minimum ? std::clamp(wanted, minimum, maximum) : maximum;
  for (int k = 1; k <= count; ++k)
    bounds.push_back(from + room * k / count);
  return bounds;
}

double levelEdgeMm(const LevelOptions& options) {
  return kEdgeShare * options.beadWidthMm;
}

double offsetGridMm(const LevelOptions& options) {
  return kGridShare * levelEdgeMm(options);
}

StackedLevels stackLevels(const geometry::TriangleMesh& part, const LevelFamily& family,
                          const LevelOptions& o, const base::RunContext& ctx) {
  base::require(!part.empty() && o.beadWidthMm > 0.0, "a part and a bead width");
  StackedLevels result;
  const layers::PartBoundary boundary(part, levelEdgeMm(o), ctx);
  std::vector<layers::PatchesOfLevel> made(static_cast<std::size_t>(family.count));
  ctx.report(0.0, "cutting layers"_text);
  base::parallelChunks(ctx, made.size(), 1, [&](std::size_t begin, std::size_t end) {
    const base::RunContext silent = ctx.quiet();
    for (std::size_t k = begin; k < end; ++k) {
      layers::LevelSurface surface = family.level(static_cast<int>(k), silent);
      surface.level = static_cast<int>(k);
      surface = layers::trimToPart(surface, boundary, {}, silent);
      layers::cleanSurface(surface, {}, silent);
      made[k] = layers::makePatches(surface, {o.beadWidthMm});
    }
  });
  std::vector<layers::Patch> slivers;
  for (layers::PatchesOfLevel& level : made) {
    std::move(level.patches.begin(), level.patches.end(), std::back_inserter(result.stack.patches));
    std::move(level.slivers.begin(), level.slivers.end(), std::back_inserter(slivers));
  }
  if (std::none_of(result.stack.patches.begin(), result.stack.patches.end(),
                   [&](const layers::Patch& p) { return isOnGround(p, family.ground); }))
    missesGround(family.groundKind);
  if (family.adapt)
    family.adapt(result.stack.patches);

  ctx.report(0.6, "ordering layers"_text);
  const layers::AbsorbOptions absorb{o.heightMaxMm, o.beadWidthMm};
  layers::Absorbed absorbed = layers::absorbSlivers(result.stack.patches, slivers, absorb);
  layers::orderForPrinting(result.stack);
  const layers::IslandOptions islands = layers::islandOptions(o.beadWidthMm);
  layers::AbsorbedIslands absorbedIslands =
      layers::absorbIslands(result.stack, islands, absorb, ctx, family.ground);
  result.mergedPieces = absorbed.merged + absorbedIslands.absorbed.merged;
  std::move(absorbedIslands.absorbed.dropped.begin(), absorbedIslands.absorbed.dropped.end(),
            std::back_inserter(absorbed.dropped));
  ctx.report(0.8, "ending layers on the surface"_text);
  if (family.endsBelowSurface)
    layers::followTop(result.stack, boundary,
                      {o.heightMinMm, o.heightMaxMm, kFineShare * o.beadWidthMm}, ctx);
  result.statistics = layers::layerStatistics(result.stack, {o.heightMinMm, o.heightMaxMm});
  reportDropped(absorbed.dropped, result);
  reportLeftOut(part, result);
  reportUnsupported(layers::patchesInAir(absorbedIslands.support, islands), family.groundKind,
                    result);
  return result;
}

} // namespace voluta::substrate
