#include "substrate/blend_levels.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/measures.h"
#include "substrate/levels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

namespace voluta::substrate {

namespace {

using Eigen::Vector3d;

constexpr double kOnGroundMm = 1e-3;
constexpr double kFarMm = 1e4;

[[noreturn]] void refuse(const base::Message& what, const base::Message& remedy,
                         const Vector3d* at = nullptr) {
  throw base::Error(
      base::ErrorCode::UnusableInput, what,
      at ? base::Value(base::message("at {point:.1f}"_text, base::Point{at->x(), at->y(), at->z()}))
         : base::Value("end surface"_text),
      remedy);
}

// Returns the distance [mm] along a ray from a foot to the end surface; negative if it misses it.
double distanceToEnd(const Vector3d& foot, const Vector3d& direction, const BlendOptions& o) {
  if (o.end) {
    const auto hit = o.end->firstHit(foot, foot + kFarMm * direction);
    return hit ? kFarMm * hit->t : -1.0;
  }
  return direction.z() > 1e-6 ? (o.endHeightMm - foot.z()) / direction.z() : -1.0;
}

int layersFor(double minimum, double mean, double maximum, const LevelOptions& o) {
  const int fewest = std::max(1, static_cast<int>(std::ceil(maximum / o.heightMaxMm - 1e-9)));
  const int greatest = static_cast<int>(std::floor(minimum / o.heightMinMm + 1e-9));
  if (fewest > greatest)
    refuse(base::message("no number of layers between the surface and the end surface keeps "
                         "the layer height within {least} to {most} mm: their distance is "
                         "{shortest:.3g} to {longest:.3g} mm"_text,
                         base::number(o.heightMinMm), base::number(o.heightMaxMm),
                         base::number(minimum), base::number(maximum)),
           "choose an end surface of more similar shape, or a smaller part"_text);
  return std::clamp(static_cast<int>(std::lround(mean / o.layerHeightMm)), fewest, greatest);
}

} // namespace

std::vector<layers::LevelSurface> blendLevels(const GroundDistance& ground,
                                              const geometry::MeshQuery& part,
                                              const Eigen::AlignedBox3d& box, const BlendOptions& o,
                                              const base::RunContext& ctx) {
  const double edge = levelEdgeMm(o.levels);
  layers::LevelSurface start = offsetLevel(ground, kOnGroundMm, 1.0, box, edge, ctx);
  std::vector<double> distance(start.surface.vertices.size());
  // Whether the ray passes the part; other rays are ignored
  std::vector<std::uint8_t> passes(distance.size());
  base::parallelChunks(ctx, distance.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      distance[v] = distanceToEnd(start.surface.vertices[v], start.direction[v], o);
      const int steps = static_cast<int>(std::ceil(distance[v] / edge));
      for (int i = 0; i <= steps && !passes[v]; ++i) {
        const Vector3d p = start.surface.vertices[v] + distance[v] * i / steps * start.direction[v];
        passes[v] = part.closest(p, 2.0 * edge).triangle >= 0 || part.inside(p);
      }
    }
  });
  std::erase_if(start.surface.triangles, [&](const auto& t) {
    return std::any_of(t.begin(), t.end(), [&](int v) {
      const auto i = static_cast<std::size_t>(v);
      return distance[i] < kOnGroundMm || !passes[i];
    });
  });
  if (start.surface.triangles.empty())
    refuse("no normal of the surface below the part hits the end surface"_text,
           "choose an end surface over the part's foot"_text);
  start.thicknessMm = distance; // dropUnusedVertices() keeps it in step with the vertices
  layers::dropUnusedVertices(start);
  double minimum = kFarMm, maximum = 0.0, sum = 0.0;
  for (const double t : start.thicknessMm) {
    minimum = std::min(minimum, t);
    maximum = std::max(maximum, t);
    sum += t;
  }
  const int count =
      layersFor(minimum, sum / static_cast<double>(start.thicknessMm.size()), maximum, o.levels);
  std::vector<layers::LevelSurface> levels;
  for (int k = 0; k < count; ++k) {
    layers::LevelSurface level = start;
    for (std::size_t v = 0; v < level.thicknessMm.size(); ++v) {
      level.surface.vertices[v] += (k + 0.5) / count * start.thicknessMm[v] * start.direction[v];
      level.thicknessMm[v] = start.thicknessMm[v] / count;
    }
    for (std::size_t t = 0; t < level.surface.triangles.size(); ++t)
      if (geometry::triangleNormal(level.surface, t)
              .dot(geometry::triangleNormal(start.surface, t)) < 0.0)
        refuse(base::message("layers on this surface would fold from layer {layer} on: its normals"
                             " cross before the end surface"_text,
                             k + 1),
               "fill the hollow first, or use `layerShape=offset`"_text,
               &level.surface.corner(t, 0));
    levels.push_back(std::move(level));
  }
  return levels;
}

} // namespace voluta::substrate
