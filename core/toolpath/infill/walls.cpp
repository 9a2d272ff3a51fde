#include "toolpath/infill/walls.h"

#include "base/index.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/infill/regions.h"
#include "toolpath/surface_fields.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace voluta::toolpath {

namespace {
using base::at;

// Maximum closing, in hatches. With kWallInwards it has to be less than the distance from the wall
// to the boundary.
constexpr double kMaxClosing = 1.0;
// mm, for beads of the usual width; shorter rings are no more than a blob.
constexpr double kFar = 2.0, kShortest = 3.0;

// Returns the distance to `curves` in hatches, positive where `inside` holds. On the side other
// than `asked` it is computed only at vertices next to the curves.
template <typename Inside>
std::vector<double> signedDistance(const PatchSurface& s, const std::vector<SurfaceCurve>& curves,
                                   const std::vector<double>& hatchMm, double beadScale, bool asked,
                                   Inside&& inside) {
  std::vector<char> onwards(s.position.size());
  for (std::size_t v = 0; v < onwards.size(); ++v)
    onwards[v] = inside(v) == asked;
  std::vector<double> e = distanceToSegments(s, segmentsOf(s, curves), kFar * beadScale, onwards);
  for (std::size_t v = 0; v < e.size(); ++v)
    e[v] = (inside(v) ? e[v] : -e[v]) / hatchMm[v];
  return e;
}
} // namespace

double wallClosing(double level) {
  return std::min(kMaxClosing, std::max(0.1, level - 0.05));
}

LevelSet openedAt(const PatchSurface& s, const std::vector<double>& depth,
                  const std::vector<double>& hatchMm, double beadScale, double level,
                  double inwards) {
  const auto inner = isolines(s, depth, level + inwards);
  if (inner.empty())
    return {};
  const std::vector<double> fromInner =
      signedDistance(s, inner, hatchMm, beadScale, false,
                     [&](std::size_t v) { return depth[v] >= level + inwards; });
  // Where the region is hardly deep enough, the inner region is fragmented: close the gaps before
  // offsetting back outwards.
  const double closing = wallClosing(level), out = -(inwards + closing);
  const auto outer = isolines(s, fromInner, out);
  if (outer.empty())
    return {};
  return {signedDistance(s, outer, hatchMm, beadScale, true,
                         [&](std::size_t v) { return fromInner[v] >= out; }),
          closing};
}

std::vector<SurfaceCurve> wallsAround(const PatchSurface& s, const LevelSet& region,
                                      double beadScale) {
  if (region.value.empty())
    return {};
  std::vector<SurfaceCurve> curves = isolines(s, region.value, region.level);
  std::erase_if(curves, [&](const SurfaceCurve& c) { return lengthOf(c) < kShortest * beadScale; });
  return curves;
}

std::vector<SurfaceCurve> wallAt(const PatchSurface& s, const std::vector<double>& depth,
                                 const std::vector<double>& hatchMm, double beadScale,
                                 double level) {
  return wallsAround(s, openedAt(s, depth, hatchMm, beadScale, level, kWallInwards), beadScale);
}

namespace {
constexpr double kThin = 0.3; // Depth of the thinnest joined wall [hatches]
}

void dropDashes(const PatchSurface& s, const std::vector<double>& depth, double deepest,
                std::vector<SurfaceCurve>& walls) {
  if (walls.size() < 2)
    return;
  const Regions regions = regionsAbove(s, depth, kThin);
  std::vector<double> middle(at(regions.count), 0.0); // the largest depth
  for (std::size_t v = 0; v < depth.size(); ++v)
    if (const int region = regions.ofVertex[v]; region >= 0)
      middle[at(region)] = std::max(middle[at(region)], depth[v]);
  const auto regionOf = [&](const SurfaceCurve& c) {
    const auto& triangle = s.triangles[at(c.points.front().triangle)];
    return std::max({regions.ofVertex[at(triangle[0])], regions.ofVertex[at(triangle[1])],
                     regions.ofVertex[at(triangle[2])]});
  };
  std::vector<int> count(at(regions.count), 0);
  for (const SurfaceCurve& c : walls)
    if (const int region = regionOf(c); region >= 0)
      ++count[at(region)];
  std::erase_if(walls, [&](const SurfaceCurve& c) {
    const int region = regionOf(c);
    return region >= 0 && count[at(region)] > 1 && middle[at(region)] <= deepest;
  });
}

void dropJunctionRings(const PatchSurface& s, const std::vector<double>& depth, double hatchMm,
                       std::vector<SurfaceCurve>& walls) {
  constexpr double kRing = 6.5, kArms = 2.5; // [hatches]
  const auto isRing = [&](const SurfaceCurve& c) { return lengthOf(c) < kRing * hatchMm; };
  if (std::ranges::none_of(walls, isRing))
    return;
  const Regions regions = regionsAbove(s, depth, kThin);
  std::vector<Eigen::AlignedBox3d> extent(at(regions.count));
  for (std::size_t v = 0; v < depth.size(); ++v)
    if (regions.ofVertex[v] >= 0)
      extent[at(regions.ofVertex[v])].extend(s.position[v]);
  std::erase_if(walls, [&](const SurfaceCurve& c) {
    if (!isRing(c))
      return false;
    const auto& triangle = s.triangles[at(c.points.front().triangle)];
    Eigen::AlignedBox3d ring;
    for (const SurfacePoint& p : c.points)
      ring.extend(p.position);
    return std::ranges::any_of(triangle, [&](int v) {
      const int region = regions.ofVertex[at(v)];
      return region >= 0 &&
             extent[at(region)].diagonal().norm() > ring.diagonal().norm() + kArms * hatchMm;
    });
  });
}

} // namespace voluta::toolpath
