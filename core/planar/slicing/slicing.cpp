#include "planar/slicing/slicing.h"

#include "base/index.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "geometry/append_mesh.h"
#include "geometry/measures.h"
#include "layers/clean_surface.h"
#include "layers/islands.h"
#include "layers/layer_findings.h"
#include "layers/order.h"
#include "layers/patches.h"
#include "plan/blocking_share.h"
#include "plan/finding_kinds.h"
#include "planar/nudged.h"
#include "planar/slicing/region_mesh.h"
#include "planar/slicing/section_paths.h"
#include "planar/slicing/support_columns.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace voluta::planar {

using Eigen::Vector3d;
using layers::LevelSurface;
using layers::Patch;

namespace {

using base::at;

// Returns whether the even-odd triangulation has the section's area, which it does not if loops
// overlap.
bool fills(const RegionMesh& region, const Section& section) {
  double area = 0.0;
  for (const auto& t : region.triangles) {
    const Eigen::Vector2d a = region.points[at(t[1])] - region.points[at(t[0])],
                          b = region.points[at(t[2])] - region.points[at(t[0])];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  constexpr double kSame = 1e-6;
  return std::abs(area - areaOf(section)) <= kSame * (1.0 + area);
}

std::optional<LevelSurface> surfaceOf(const Section& section, double edgeMm,
                                      const base::RunContext& ctx) {
  const Vector3d& normal = section.plane.normal;
  const PlaneFrame frame = frameOf(normal);
  std::vector<Eigen::Vector2d> points;
  for (const Vector3d& p : section.points)
    points.emplace_back(frame.across.dot(p), frame.along.dot(p));
  const std::optional<RegionMesh> region = meshRegion(points, section.edges, edgeMm);
  if (!region || !fills(*region, section))
    return std::nullopt;
  LevelSurface s;
  s.surface.vertices = section.points;
  for (const RegionMesh::Split& split : region->splits)
    s.surface.vertices.push_back((1.0 - split.t) * section.points[at(split.a)] +
                                 split.t * section.points[at(split.b)]);
  for (std::size_t i = s.surface.vertices.size(); i < region->points.size(); ++i)
    s.surface.vertices.push_back(region->points[i].x() * frame.across +
                                 region->points[i].y() * frame.along +
                                 section.plane.offsetMm * normal);
  s.surface.triangles = region->triangles;
  s.thicknessMm.assign(s.surface.vertices.size(), 1.0);
  s.direction.assign(s.surface.vertices.size(), normal);
  s.clearDirection = s.direction;
  layers::cleanSurface(s, {}, ctx);
  return s;
}

double volumeOf(const Patch& patch) {
  double sum = 0.0;
  for (std::size_t t = 0; t < patch.surface.triangles.size(); ++t) {
    const auto& tri = patch.surface.triangles[t];
    sum += geometry::triangleArea(patch.surface, t) *
           (patch.thicknessMm[at(tri[0])] + patch.thicknessMm[at(tri[1])] +
            patch.thicknessMm[at(tri[2])]) /
           3.0;
  }
  return sum;
}

// Returns the middle of all pieces, seen along z.
Eigen::Vector2d centreOf(const std::vector<Piece>& pieces) {
  Eigen::AlignedBox3d box;
  for (const Piece& piece : pieces)
    box.extend(geometry::bounds(piece.solid.mesh));
  return box.isEmpty() ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(box.center().head<2>());
}

// A layer to create.
struct Level {
  std::size_t piece;
  double low, high; // above the piece's base
  int number;       // over all pieces
};

// Adds the support columns of every piece, one or more patches per level.
void addColumns(SliceResult& result, const std::vector<Piece>& pieces,
                const std::vector<std::vector<double>>& bounds, const SliceOptions& options,
                const layers::SupportPlaces& places, const base::RunContext& ctx) {
  double unheld = 0.0;
  Vector3d unheldAt = Vector3d::Zero();
  int level = 0;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    std::vector<Sections> sections;
    for (const Piece& piece : pieces)
      sections.emplace_back(piece.solid.mesh, pieces[p].base.normal);
    ColumnOptions with;
    with.overhangRad = options.overhangRad;
    with.beadWidthMm = options.beadWidthMm;
    with.plate = options.plate;
    with.rule = options.supports;
    with.places = &places;
    const SupportColumns columns = supportColumns(pieces, p, sections, bounds[p], with, ctx);
    if (columns.unheldMm2 > 0.0 && unheld == 0.0)
      unheldAt = columns.unheldAt;
    unheld += columns.unheldMm2;
    for (std::size_t k = 0; k < columns.sections.size(); ++k, ++level) {
      if (columns.sections[k].empty())
        continue;
      LevelSurface surface = sectionSurface(columns.sections[k], options.edgeMm, ctx.quiet());
      surface.level = level;
      surface.thicknessMm.assign(surface.surface.vertices.size(), bounds[p][k + 1] - bounds[p][k]);
      for (Patch& patch : layers::makePatches(surface, {options.beadWidthMm}).patches) {
        patch.group = layers::kSupportGroup;
        result.stack.patches.push_back(std::move(patch));
      }
    }
  }
  if (unheld > 0.0)
    result.findings.push_back(plan::makeFinding(plan::FindingKind::UnheldOverhang,
                                                {{"area", base::mm2(unheld)}}, unheldAt));
}

} // namespace

LevelSurface sectionSurface(const Section& section, double edgeMm, const base::RunContext& ctx) {
  auto surface = surfaceOf(section, edgeMm, ctx);
  if (!surface)
    surface = surfaceOf(filledByWinding(section), edgeMm, ctx);
  if (!surface)
    sectionCrosses();
  return std::move(*surface);
}

void finishStack(SliceResult& result, const std::vector<Patch>& slivers,
                 const SliceOptions& options, const base::RunContext& ctx) {
  layers::LayerStack& stack = result.stack;
  const layers::AbsorbOptions absorb{options.heights.maxMm, options.beadWidthMm};
  layers::Absorbed absorbed = layers::absorbSlivers(stack.patches, slivers, absorb);
  const layers::IslandOptions islands = layers::islandOptions(options.beadWidthMm);
  layers::AbsorbedIslands absorbedIslands = layers::absorbIslands(stack, islands, absorb, ctx);
  std::move(absorbedIslands.absorbed.dropped.begin(), absorbedIslands.absorbed.dropped.end(),
            std::back_inserter(absorbed.dropped));

  for (const Patch& patch : stack.patches)
    (patch.group == layers::kSupportGroup ? result.supportVolumeMm3
                                          : result.volumeOfPiece[at(patch.group)]) +=
        volumeOf(patch);
  double deposited = 0.0;
  for (const double volume : result.volumeOfPiece)
    deposited += volume;
  const layers::NotPrinted dropped = layers::notPrinted(absorbed.dropped);
  result.slivers = dropped.pieces;
  result.sliverVolumeMm3 = dropped.volumeMm3;
  if (auto finding = layers::sliversFinding(dropped, deposited, plan::kBlockingShare))
    result.findings.push_back(std::move(*finding));

  result.statistics =
      layers::layerStatistics(stack, {options.heights.minMm, options.heights.maxMm});
  const layers::InAir inAir = layers::patchesInAir(absorbedIslands.support, islands);
  result.unsupportedPatches = inAir.patches;
  if (inAir.patches > 0)
    result.findings.push_back(plan::makeFinding(
        plan::FindingKind::BeginsInAir, {{"pieces", inAir.patches}}, inAir.firstAt, inAir.patches));
}

SliceResult slicePieces(const std::vector<Piece>& pieces, const SliceOptions& options,
                        const base::RunContext& ctx, const layers::SupportPlaces& places) {
  const base::Stopwatch watch;
  SliceResult result;
  std::vector<Sections> sections;
  std::vector<std::vector<double>> boundsOf;
  std::vector<Level> levels;
  geometry::TriangleMesh pocketed; // a single piece without its pockets; empty: it has none
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    HeightOptions heights = options.heights;
    if (pieces[p].baseTag != kPlate)
      heights.firstMm = 0.0;
    const std::vector<double> bounds = layerBounds(pieces[p], heights);
    boundsOf.push_back(bounds);
    if (pieces.size() == 1)
      result.stack.pockets = placePockets(pieces[p], bounds, options.stitches);
    if (!result.stack.pockets.empty()) {
      pocketed = pieces[p].solid.mesh;
      geometry::appendMesh(pocketed, pocketSurfaces(result.stack.pockets, options.stitches.shape));
    }
    sections.emplace_back(pocketed.empty() ? pieces[p].solid.mesh : pocketed,
                          pieces[p].base.normal);
    for (std::size_t k = 0; k + 1 < bounds.size(); ++k)
      levels.push_back({p, bounds[k], bounds[k + 1], static_cast<int>(levels.size())});
    result.layersOfPiece.push_back(static_cast<int>(bounds.size()) - 1);
  }
  result.volumeOfPiece.assign(pieces.size(), 0.0);
  const Eigen::Vector2d centre = centreOf(pieces);
  const auto sectionAt = [&](std::size_t piece, double offsetMm) {
    return corrected(sections[piece].at(offsetMm), options.sizes, centre);
  };

  std::vector<layers::PatchesOfLevel> made(levels.size());
  const base::RunContext silent = ctx.quiet();
  base::parallelWithProgress(ctx, levels.size(), 0.7, "slicing"_text, [&](std::size_t i) {
    const Level& level = levels[i];
    const double middle = pieces[level.piece].base.offsetMm + 0.5 * (level.low + level.high);
    LevelSurface surface = atOrNear(
        middle,
        [&](double offsetMm) {
          return surfaceOf(sectionAt(level.piece, offsetMm), options.edgeMm, silent);
        },
        [&] { return sectionSurface(sectionAt(level.piece, middle), options.edgeMm, silent); });
    surface.level = level.number;
    surface.thicknessMm.assign(surface.surface.vertices.size(), level.high - level.low);
    made[i] = layers::makePatches(surface, {options.beadWidthMm});
  });
  std::vector<Patch> slivers;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (Patch& patch : made[i].patches) {
      patch.group = static_cast<int>(levels[i].piece);
      result.stack.patches.push_back(std::move(patch));
    }
    for (Patch& sliver : made[i].slivers) {
      sliver.group = static_cast<int>(levels[i].piece);
      slivers.push_back(std::move(sliver));
    }
  }
  const bool isSupported = std::ranges::any_of(
      places.places, [](const layers::SupportPlace& p) { return layers::wantsColumns(p.rule); });
  if (isSupported || layers::wantsColumns(options.supports)) {
    ctx.report(0.7, "supports"_text);
    addColumns(result, pieces, boundsOf, options, places, ctx);
  }
  layers::orderForPrinting(result.stack);
  ctx.report(0.8, "checking layers"_text);
  finishStack(result, slivers, options, ctx);
  assignLayers(result.stack.pockets, result.stack);
  result.seconds.extract = watch.seconds();
  return result;
}

} // namespace voluta::planar
