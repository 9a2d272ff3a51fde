#include "layers/stair_steps.h"

#include "base/parallel.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"

#include <algorithm>
#include <cmath>

namespace voluta::layers {

namespace {
using Eigen::Vector3d;

// Sums over the edges of one patch.
struct Sums {
  double stepTimesArea = 0.0, maxMm = 0.0;
};

// The part's surface, and the faces of it that are looked at.
struct Surface {
  const geometry::TriangleMesh& part;
  const std::vector<char>& isMeant; // per triangle
  geometry::MeshQuery query{part, geometry::MeshQuery::Of::Surface};
};

void addEdge(const Patch& patch, int from, int to, const Surface& surface, Sums& sums) {
  // Flatter surfaces have wider steps than a layer has room for.
  constexpr double kMinSine = 0.05;
  const auto a = static_cast<std::size_t>(from), b = static_cast<std::size_t>(to);
  if (!patch.innerRim.empty() && patch.innerRim[a] != 0 && patch.innerRim[b] != 0)
    return;
  const Vector3d &p = patch.surface.vertices[a], &q = patch.surface.vertices[b];
  const double thickness = 0.5 * (patch.thicknessMm[a] + patch.thicknessMm[b]);
  const auto nearest = surface.query.closest(0.5 * (p + q), thickness);
  if (nearest.triangle < 0 || !surface.isMeant[static_cast<std::size_t>(nearest.triangle)])
    return;
  const Vector3d direction = (patch.direction[a] + patch.direction[b]).normalized();
  const double cosine = std::abs(direction.dot(
      geometry::triangleNormal(surface.part, static_cast<std::size_t>(nearest.triangle))));
  const double sine = std::max(kMinSine, std::sqrt(std::max(0.0, 1.0 - cosine * cosine)));
  const double stepMm = thickness * cosine;
  sums.stepTimesArea += stepMm * (q - p).norm() * thickness / sine;
  sums.maxMm = std::max(sums.maxMm, stepMm);
}

Sums stepsOfPatch(const Patch& patch, const Surface& surface) {
  Sums sums;
  if (patch.group == kSupportGroup)
    return sums;
  const std::vector<geometry::HalfEdge> edges = geometry::sortedHalfEdges(patch.surface);
  geometry::forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    if (end - begin == 1)
      addEdge(patch, edges[begin].low, edges[begin].high, surface, sums);
  });
  return sums;
}
} // namespace

StepFigures stepsOf(const LayerStack& stack, const geometry::TriangleMesh& part,
                    const base::RunContext& ctx) {
  return stepsOn(stack, part, std::vector<char>(part.triangles.size(), 1), ctx);
}

StepFigures stepsOn(const LayerStack& stack, const geometry::TriangleMesh& part,
                    const std::vector<char>& isMeant, const base::RunContext& ctx) {
  StepFigures figures;
  double area = 0.0;
  for (std::size_t t = 0; t < isMeant.size(); ++t)
    area += isMeant[t] ? geometry::triangleArea(part, t) : 0.0;
  if (area <= 0.0)
    return figures;
  const Surface surface{part, isMeant};
  std::vector<Sums> sums(stack.patches.size());
  base::parallelChunks(ctx, sums.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      sums[i] = stepsOfPatch(stack.patches[i], surface);
  });
  for (const Sums& s : sums) {
    figures.meanMm += s.stepTimesArea / area;
    figures.maxMm = std::max(figures.maxMm, s.maxMm);
  }
  return figures;
}

} // namespace voluta::layers
