#include "substrate/lathe_layers.h"

#include "base/error.h"
#include "geometry/boundary.h"
#include "geometry/measures.h"
#include "geometry/subtract.h"
#include "substrate/levels.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>

namespace voluta::substrate {

namespace {

using Eigen::Vector3d;

constexpr double kHardlyOverMm = 1e-2; // Protrusion that the facets of rod or part can cause

[[noreturn]] void refuse(const base::Message& what, const base::Message& remedy) {
  throw base::Error(base::ErrorCode::UnusableInput, what, "rod"_text, remedy);
}

Vector3d radial(const Vector3d& p) {
  return Vector3d(0.0, p.y(), p.z()).normalized();
}

layers::Ground groundOf(const RodSurface& rod, bool followsRod) {
  if (!followsRod)
    return rodGround(rod);
  return {[distance = rod.distance()](const Vector3d& p) { return distance.signedMm(p); }};
}

double farthest(const geometry::TriangleMesh& part, const RodSurface& rod, bool followsRod) {
  double maximum = 0.0;
  for (const Vector3d& p : part.vertices)
    maximum = std::max(maximum, followsRod ? rod.distance().signedMm(p) : p.tail<2>().norm());
  return maximum;
}

// If the rod is not round, the bottom of a level leaves the rod's surface between the rims of
// levels, which are half a layer high. Makes the first patch over the rod thick enough there to
// rest on it.
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

} // namespace

layers::Ground rodGround(const RodSurface& rod) {
  return {[rod](const Vector3d& p) { return rod.over(p); }};
}

geometry::TriangleMesh partAroundRod(const geometry::TriangleMesh& part, const RodSurface& rod) {
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  const auto& profile = rod.rod().profile;
  const double first = profile.front().x(), last = profile.back().x();
  if (box.isEmpty() || box.min().x() < first || box.max().x() > last)
    refuse(base::message("the part extends from x = {from:.4g} to {to:.4g} mm, beyond an end "
                         "of the rod at {firstEnd:.4g} or {lastEnd:.4g} mm"_text,
                         base::number(box.min().x()), base::number(box.max().x()),
                         base::number(first), base::number(last)),
           "move the part along the rod, or use a longer rod"_text);
  double over = 0.0;
  for (const auto& triangle : part.triangles)
    for (int v : triangle)
      over = std::max(over, rod.over(part.vertices[static_cast<std::size_t>(v)]));
  std::optional<geometry::TriangleMesh> remainder = geometry::TriangleMesh();
  if (over > kHardlyOverMm) {
    remainder = part;
    for (const geometry::TriangleMesh& solid : rod.solids())
      if (remainder && !remainder->empty())
        remainder = geometry::subtract(*remainder, solid);
  }
  if (!remainder)
    refuse("the part is not closed or self-intersects where the rod is subtracted"_text,
           "repair the part first"_text);
  if (remainder->empty())
    refuse("the rod is thicker than the part and contains all of it"_text,
           "use a thinner rod, or print the part larger"_text);
  return std::move(*remainder);
}

std::vector<double> latheBounds(const geometry::TriangleMesh& part, const RodSurface& rod,
                                const LatheOptions& o) {
  base::require(!part.empty(), "a part");
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  const double from = o.followsRod ? 0.0 : rod.radiiBetween(box.min().x(), box.max().x()).minMm;
  const double to = farthest(part, rod, o.followsRod);
  if (to - from < o.heightMinMm)
    refuse(base::message("the part extends {height:.3g} mm beyond the rod, less than a layer "
                         "of {least:.3g} mm"_text,
                         base::number(std::max(0.0, to - from)), base::number(o.heightMinMm)),
           "use a thinner rod, or print the part larger"_text);
  return levelBounds(from, to, o);
}

LatheLayers latheLayers(const geometry::TriangleMesh& part, const RodSurface& rod,
                        const LatheOptions& o, const base::RunContext& ctx) {
  const std::vector<double> bounds = latheBounds(part, rod, o);
  const double edge = levelEdgeMm(o);
  Eigen::AlignedBox3d box = geometry::bounds(part);
  const platform::RadiusRange radii = rod.radiiBetween(box.min().x(), box.max().x());
  box.min().array() -= 2.0 * edge;
  box.max().array() += 2.0 * edge;
  LevelFamily family;
  family.count = static_cast<int>(bounds.size()) - 1;
  family.groundKind = GroundKind::Rod;
  family.ground = groundOf(rod, o.followsRod);
  std::optional<OffsetLevels> offsets;
  if (o.followsRod)
    offsets.emplace(rod.distance(), box, offsetGridMm(o));
  family.level = [&](int k, const base::RunContext& silent) {
    const double inner = bounds[static_cast<std::size_t>(k)],
                 outer = bounds[static_cast<std::size_t>(k) + 1];
    const double middle = 0.5 * (inner + outer), thickness = outer - inner;
    return offsets ? offsets->at(middle, thickness, silent)
                   : cylinderLevel(middle, thickness, box.min().x(), box.max().x(), edge);
  };
  if (!o.followsRod && radii.minMm < radii.maxMm)
    family.adapt = [&](std::vector<layers::Patch>& patches) {
      followRod(patches, bounds, family.ground, o);
    };
  LatheLayers result{stackLevels(part, family, o, ctx), {}};
  result.outerMm.assign(bounds.begin() + 1, bounds.end());
  return result;
}

Overhang latheOverhang(const geometry::TriangleMesh& part, const RodSurface& rod,
                       const LatheOptions& o, const OverhangRule& rule) {
  return findOverhang(
      part, groundOf(rod, o.followsRod),
      o.followsRod
      ? [distance = rod.distance()](const Vector3d& p) -> Vector3d { return distance.outward(p); }
      : std::function<Vector3d(const Vector3d&)>(radial),
      rule);
}

} // namespace voluta::substrate
