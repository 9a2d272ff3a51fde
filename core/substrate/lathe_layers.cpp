#include "substrate/lathe_layers.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/units.h"
#include "geometry/boundary.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "geometry/subtract.h"
#include "layers/absorb.h"
#include "layers/clean_surface.h"
#include "layers/follow_top.h"
#include "layers/islands.h"
#include "layers/layer_findings.h"
#include "layers/order.h"
#include "layers/part_boundary.h"
#include "layers/patches.h"
#include "layers/trim.h"
#include "substrate/levels.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

namespace voluta::substrate {

namespace {

using Eigen::Vector3d;

constexpr double kRodChordMm = 1e-3;
constexpr double kHardlyOverMm = 1e-2;  // over the rod: what facets of either leave
constexpr double kEdgeShare = 0.4;      // of a bead's width: edges of levels
constexpr double kFineShare = 0.17;     // of a bead's width: where last layers end on the surface
constexpr double kBlockingShare = 0.01; // of the volume that is not laid
// Of a layer's height: a middle this near to the rod is the first layer's.
constexpr double kOnRod = 0.75;

[[noreturn]] void refuse(const std::string& what, const std::string& remedy) {
  throw base::Error(base::ErrorCode::UnusableInput, what, "rod", remedy);
}

// Outer bounds of levels, the rod's own first.
std::vector<double> levelBounds(double from, double to, const LatheOptions& o) {
  std::vector<double> bounds{from};
  if (o.firstLayerMm > 0.0 && from + o.firstLayerMm < to) {
    from += o.firstLayerMm;
    bounds.push_back(from);
  }
  const double room = to - from;
  const int most = static_cast<int>(std::floor(room / o.heightMinMm + 1e-9)),
            least = static_cast<int>(std::ceil(room / o.heightMaxMm - 1e-9));
  const int wanted = static_cast<int>(std::lround(room / o.layerHeightMm));
  // Where no number of layers is within the limits, the surface takes what is left.
  const int count = most >= least ? std::clamp(wanted, least, most) : most;
  for (int k = 1; k <= count; ++k)
    bounds.push_back(from + room * k / count);
  return bounds;
}

// Facets that face the axis more than they may, sampled so finely that the way outwards hardly
// turns over a sample.
void findOverhang(const geometry::TriangleMesh& part, const layers::Ground& ground,
                  const LatheOptions& options, double contactMm, LatheLayers& result) {
  constexpr int kMostSteps = 16;
  const double least = -std::sin(options.overhangRad);
  double worst = least;
  Vector3d at = Vector3d::Zero();
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    const Vector3d &a = part.corner(t, 0), &b = part.corner(t, 1), &c = part.corner(t, 2);
    const Vector3d n = geometry::triangleNormal(part, t);
    // Across the axis: along it the way outwards stays.
    const auto across = [](const Vector3d& v) { return v.tail<2>().norm(); };
    const double widest = std::max({across(b - a), across(c - b), across(a - c)});
    const int m = std::clamp(static_cast<int>(std::ceil(widest)), 1, kMostSteps);
    const double area = geometry::triangleArea(part, t) / (m * m);
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < 2 * (m - i) - 1; ++j) {
        // The centre of the j-th small triangle of strip i.
        const double third = j % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
        const double u = (i + third) / m, v = (j / 2 + third) / m;
        const Vector3d p = a + u * (b - a) + v * (c - a);
        const double radius = across(p);
        if (radius <= 0.0)
          continue;
        const double lean = n.tail<2>().dot(p.tail<2>()) / radius;
        if (lean >= least - 1e-9 || ground.over(p) <= contactMm)
          continue;
        result.riskyAreaMm2 += area;
        if (lean < worst - 1e-9) {
          worst = lean;
          at = p;
        }
      }
  }
  if (result.riskyAreaMm2 > 0.0)
    result.findings.push_back(layers::layerFinding(
        "overhang", at, 1,
        fmt::format(
            "{:.3g} mm2 of the part lean out along the rod by more than {:.3g} degrees over "
            "lower layers, the most at x = {:.4g} mm, radius {:.4g} mm",
            result.riskyAreaMm2, base::radiansToDegrees(options.overhangRad), at.x(),
            at.tail<2>().norm()),
        "let the part rise from the rod at a gentler slope there", false));
}

// The levels of a rod that layers follow, and of one that they do not.
class Levels {
public:
  Levels(const geometry::RodShape& rod, const Eigen::AlignedBox3d& box, const LatheOptions& options)
      : box_(box), edge_(kEdgeShare * options.beadWidthMm) {
    inside_ = [over = rodGround(rod)](const Vector3d& p) { return over.over(p) < 0.0; };
    if (options.followsRod)
      rod_ = std::make_shared<geometry::MeshQuery>(geometry::meshOf(rod, kRodChordMm));
    box_.min().array() -= 2.0 * edge_;
    box_.max().array() += 2.0 * edge_;
  }
  layers::LevelSurface between(double inner, double outer, const base::RunContext& ctx) const {
    const double middle = 0.5 * (inner + outer), thickness = outer - inner;
    return rod_ ? offsetLevel(*rod_, middle, thickness, box_, edge_, ctx, inside_)
                : cylinderLevel(middle, thickness, box_.min().x(), box_.max().x(), edge_);
  }
  double farthest(const geometry::TriangleMesh& part) const {
    double most = 0.0;
    for (const Vector3d& p : part.vertices)
      most = std::max(most, !rod_        ? p.tail<2>().norm()
                            : inside_(p) ? 0.0
                                         : rod_->closest(p).distance);
    return most;
  }
  layers::Ground ground(const geometry::RodShape& rod) const {
    if (!rod_)
      return rodGround(rod);
    return {[query = rod_, isInside = inside_](const Vector3d& p) {
      const double far = query->closest(p).distance;
      return isInside(p) ? -far : far;
    }};
  }

private:
  Eigen::AlignedBox3d box_;
  double edge_;
  InsideTest inside_;
  std::shared_ptr<const geometry::MeshQuery> rod_;
};

// Where a rod is not round, a level's foot leaves its surface between the rims of levels, which are
// half a layer high: the first patch over it is made as thick there as it takes to lie on the rod.
void followRod(std::vector<layers::Patch>& patches, const std::vector<double>& bounds,
               const layers::Ground& ground, const LatheOptions& o) {
  constexpr double kOnRimMm = 0.02;
  for (layers::Patch& patch : patches) {
    const auto k = static_cast<std::size_t>(patch.layer);
    const double top = bounds[k + 1], middle = 0.5 * (bounds[k] + top);
    const double before = k > 0 ? 0.5 * (bounds[k - 1] + bounds[k]) : 0.0;
    std::vector<bool> isBoundary(patch.thicknessMm.size(), false);
    for (const std::vector<int>& loop : geometry::boundaryLoops(patch.surface))
      for (int v : loop)
        isBoundary[static_cast<std::size_t>(v)] = true;
    for (std::size_t v = 0; v < patch.thicknessMm.size(); ++v) {
      Vector3d& p = patch.surface.vertices[v];
      const double rod = p.tail<2>().norm() - ground.over(p);
      if (rod < before || rod > middle + kOnRimMm)
        continue;
      patch.thicknessMm[v] = std::clamp(top - rod, o.heightMinMm, o.heightMaxMm);
      if (!isBoundary[v])
        p += (top - 0.5 * patch.thicknessMm[v] - p.tail<2>().norm()) * patch.direction[v];
    }
  }
}

void tellDropped(const std::vector<layers::DroppedPiece>& dropped, LatheLayers& result) {
  const layers::NotLaid slivers = layers::notLaid(dropped);
  result.slivers = slivers.pieces;
  result.sliverVolumeMm3 = slivers.volumeMm3;
  if (auto finding = layers::sliversFinding(slivers, result.statistics.volumeMm3(), kBlockingShare))
    result.findings.push_back(std::move(*finding));
}

void tellUnsupported(const layers::InAir& inAir, LatheLayers& result) {
  result.unsupportedPatches = inAir.patches;
  if (inAir.patches > 0)
    result.findings.push_back(layers::layerFinding(
        "beginsInAir", inAir.firstAt, inAir.patches,
        fmt::format("{} pieces of layers have neither the rod nor an earlier layer under them",
                    inAir.patches),
        "turn the part on the rod, or use a thicker rod", true));
}

} // namespace

layers::Ground rodGround(const geometry::RodShape& rod) {
  return {[rod](const Vector3d& p) {
    return p.tail<2>().norm() - geometry::radiusAt(rod, p.x(), std::atan2(p.z(), p.y()));
  }};
}

geometry::TriangleMesh partAroundRod(const geometry::TriangleMesh& part,
                                     const geometry::RodShape& rod) {
  geometry::checkRod(rod);
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  const double first = rod.profile.front().x(), last = rod.profile.back().x();
  if (box.isEmpty() || box.min().x() < first || box.max().x() > last)
    refuse(fmt::format("the part reaches from x = {:.4g} to {:.4g} mm, beyond an end of the rod at "
                       "{:.4g} or {:.4g} mm",
                       box.min().x(), box.max().x(), first, last),
           "move the part along the rod, or use a longer rod");
  const layers::Ground ground = rodGround(rod);
  double over = 0.0;
  for (const auto& triangle : part.triangles)
    for (int v : triangle)
      over = std::max(over, ground.over(part.vertices[static_cast<std::size_t>(v)]));
  const auto left = over > kHardlyOverMm
                        ? geometry::subtract(part, geometry::meshOf(rod, kRodChordMm))
                        : std::optional<geometry::TriangleMesh>(geometry::TriangleMesh());
  if (!left)
    refuse("the part is not closed, or cuts itself, where the rod is taken out of it",
           "repair the part first");
  if (left->empty())
    refuse("the rod is thicker than the part: nothing of the part is outside it",
           "use a thinner rod, or print the part larger");
  return *left;
}

LatheLayers latheLayers(const geometry::TriangleMesh& part, const geometry::RodShape& rod,
                        const LatheOptions& o, const base::RunContext& ctx) {
  base::require(o.layerHeightMm > 0.0 && o.heightMinMm > 0.0 && o.heightMinMm <= o.heightMaxMm &&
                    o.beadWidthMm > 0.0 && o.firstLayerMm >= 0.0,
                "positive layer heights and bead width");
  base::require(!part.empty(), "a part");
  geometry::checkRod(rod);
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  const Levels levels(rod, box, o);
  const geometry::RadiusRange radii = geometry::radiiBetween(rod, box.min().x(), box.max().x());
  const double from = o.followsRod ? 0.0 : radii.leastMm;
  const double to = levels.farthest(part);
  if (to - from < o.heightMinMm)
    refuse(
        fmt::format("the part reaches {:.3g} mm out over the rod, less than a layer of {:.3g} mm",
                    std::max(0.0, to - from), o.heightMinMm),
        "use a thinner rod, or print the part larger");
  const std::vector<double> bounds = levelBounds(from, to, o);

  LatheLayers result;
  result.outerMm.assign(bounds.begin() + 1, bounds.end());
  const layers::PartBoundary boundary(part, kEdgeShare * o.beadWidthMm, ctx);
  std::vector<layers::PatchesOfLevel> made(result.outerMm.size());
  ctx.report(0.0, "cutting layers around the rod");
  base::parallelChunks(ctx, made.size(), 1, [&](std::size_t begin, std::size_t end) {
    const base::RunContext silent = ctx.quiet();
    for (std::size_t k = begin; k < end; ++k) {
      layers::LevelSurface surface = levels.between(bounds[k], bounds[k + 1], silent);
      surface.level = static_cast<int>(k);
      surface = layers::trimToPart(surface, boundary, {}, silent);
      layers::cleanSurface(surface, {}, silent);
      made[k] = layers::makePatches(surface, {o.beadWidthMm});
    }
  });
  std::vector<layers::Patch> crumbs;
  for (layers::PatchesOfLevel& level : made) {
    std::move(level.patches.begin(), level.patches.end(), std::back_inserter(result.stack.patches));
    std::move(level.crumbs.begin(), level.crumbs.end(), std::back_inserter(crumbs));
  }
  const layers::Ground ground = levels.ground(rod);
  const auto isOnRod = [&](const layers::Patch& patch) {
    for (std::size_t v = 0; v < patch.thicknessMm.size(); ++v)
      if (ground.over(patch.surface.vertices[v]) <= kOnRod * patch.thicknessMm[v])
        return true;
    return false;
  };
  if (std::none_of(result.stack.patches.begin(), result.stack.patches.end(), isOnRod))
    refuse("the part misses the rod: nothing of it lies on the rod",
           "move the part onto the rod's axis, or use a thicker rod");

  if (!o.followsRod && radii.leastMm < radii.mostMm)
    followRod(result.stack.patches, bounds, ground, o);

  ctx.report(0.6, "ordering layers");
  const layers::AbsorbOptions absorb{o.heightMaxMm, o.beadWidthMm};
  layers::Absorbed absorbed = layers::absorbCrumbs(result.stack.patches, crumbs, absorb);
  layers::orderForPrinting(result.stack);
  const layers::IslandOptions islands = layers::islandOptions(o.beadWidthMm);
  layers::IslandsTaken taken = layers::absorbIslands(result.stack, islands, absorb, ctx, ground);
  result.mergedPieces = absorbed.merged + taken.absorbed.merged;
  std::move(taken.absorbed.dropped.begin(), taken.absorbed.dropped.end(),
            std::back_inserter(absorbed.dropped));
  ctx.report(0.8, "ending layers on the surface");
  layers::followTop(result.stack, boundary,
                    {o.heightMinMm, o.heightMaxMm, kFineShare * o.beadWidthMm}, ctx);
  result.statistics = layers::layerStatistics(result.stack, {o.heightMinMm, o.heightMaxMm});
  tellDropped(absorbed.dropped, result);
  tellUnsupported(layers::patchesInAir(taken.support, islands), result);
  findOverhang(part, ground, o, 0.5 * (bounds[1] - bounds[0]), result);
  return result;
}

} // namespace voluta::substrate
