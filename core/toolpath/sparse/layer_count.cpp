#include "toolpath/sparse/layer_count.h"

#include "base/index.h"
#include "base/units.h"
#include "geometry/measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

using base::at;

// [thicknesses]: a larger distance between two layers is a gap; a hit closer than that to the last
// one is another patch of the same layer.
constexpr double kGap = 1.7, kSameLayer = 0.3;
constexpr double kSameDirectionDeg = 30.0;
constexpr int kSpareLayers = 2;

// Every patch is of interest.
std::vector<Eigen::AlignedBox3d> boxOf(const layers::LayerStack& stack) {
  Eigen::AlignedBox3d box;
  for (const layers::Patch& patch : stack.patches)
    box.extend(geometry::bounds(patch.surface));
  return {box};
}
} // namespace

LayerCount::LayerCount(const layers::LayerStack& stack, const base::RunContext& ctx)
    : stack_(stack), query_(stack.patches, boxOf(stack), 1.0, ctx) {
  for (const layers::Patch& patch : stack.patches)
    for (const double thickness : patch.thicknessMm)
      maxThicknessMm_ = std::max(maxThicknessMm_, thickness);
}

// Calls layer(hit, distance) for each layer that counts; stops if it returns false.
template <typename F>
void LayerCount::walk(std::size_t patch, const Vector3d& place, const Vector3d& ray,
                      double thicknessMm, int enough, F&& layer) const {
  static const double sameDirection = std::cos(base::degreesToRadians(kSameDirectionDeg));
  const double start = kSameLayer * thicknessMm;
  const Vector3d from = place + start * ray, to = place + kGap * maxThicknessMm_ * enough * ray;
  Eigen::AlignedBox3d box(from);
  box.extend(to);
  std::vector<int> near = query_.near(box, 0, static_cast<int>(stack_.patches.size()));
  // Curved layers nest: the boxes of far more of them are near than can follow each other here.
  const layers::Patch& own = stack_.patches[patch];
  std::erase_if(near, [&](int p) {
    const layers::Patch& other = stack_.patches[at(p)];
    return other.item != own.item ||
           (other.group == own.group && std::abs(other.layer - own.layer) > enough + kSpareLayers);
  });
  std::vector<layers::StackQuery::Place> hits;
  query_.hits(near, from, to, hits);
  double last = 0.0, lastThickness = thicknessMm;
  for (const layers::StackQuery::Place& hit : hits) {
    const layers::Patch& other = stack_.patches[at(hit.patch)];
    const auto vertex = at(other.surface.triangles[at(hit.triangle)][0]);
    const double thickness = other.thicknessMm[vertex];
    const double distance = start + hit.distance;
    if (distance - last > kGap * std::max(thickness, lastThickness) ||
        other.group == layers::kSupportGroup ||
        std::abs(other.direction[vertex].dot(ray)) < sameDirection)
      return;
    if (distance - last < kSameLayer * std::min(thickness, lastThickness))
      continue;
    if (!layer(hit, distance))
      return;
    last = distance;
    lastThickness = thickness;
  }
}

LayerCount::Layers LayerCount::along(std::size_t patch, const Vector3d& place, const Vector3d& ray,
                                     double thicknessMm, int enough) const {
  Layers layers;
  if (enough > 0)
    walk(patch, place, ray, thicknessMm, enough, [&](const auto&, double distance) {
      layers = {layers.count + 1, distance};
      return layers.count < enough;
    });
  return layers;
}

int LayerCount::patchBelow(std::size_t patch, const Vector3d& place, const Vector3d& direction,
                           double thicknessMm) const {
  int below = -1;
  walk(patch, place, -direction, thicknessMm, 1, [&](const auto& hit, double) {
    below = hit.patch;
    return false;
  });
  return below;
}

} // namespace voluta::toolpath
