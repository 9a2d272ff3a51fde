#include "curved/field_score.h"

#include "base/error.h"
#include "curved/convex_front.h"
#include "curved/field_fit.h"
#include "curved/nozzle_reach.h"
#include "curved/voxels_by_level.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace voluta::curved {

namespace {

// Returns, for each of the sorted limits, the number of values below it.
std::vector<std::size_t> numberBelow(const std::vector<float>& values,
                                     const std::vector<float>& limits) {
  std::vector<std::size_t> number(limits.size() + 1, 0);
  for (const float v : values)
    ++number[static_cast<std::size_t>(std::upper_bound(limits.begin(), limits.end(), v) -
                                      limits.begin())];
  std::partial_sum(number.begin(), number.end(), number.begin());
  return number;
}

} // namespace

double bestScale(const std::vector<float>& slope, const LayerLimits& limits, double* within) {
  base::require(!slope.empty(), "bestScale: a voxel or more");
  std::vector<float> halves = slope;
  const auto middle = halves.begin() + static_cast<std::ptrdiff_t>(halves.size() / 2);
  std::nth_element(halves.begin(), middle, halves.end());
  const double median = std::max(1e-3f, *middle);
  // Candidate scales range from the nominal height at the median slope to the minimum height there.
  const double nominal = 1.0 / median;
  constexpr int kSteps = 60;
  constexpr double kMinGain = 1e-3; // Share of voxels that a height further from nominal must gain
  const auto scaleAt = [&](int i) {
    return nominal * std::pow(limits.heightMm / limits.minMm, i / double{kSteps});
  };
  // Slopes whose thickness h / (scale * slope) is within [min, max].
  const auto low = [&](int i) {
    return static_cast<float>(limits.heightMm / (limits.maxMm * scaleAt(i)));
  };
  const auto beyond = [&](int i) {
    return std::nextafter(static_cast<float>(limits.heightMm / (limits.minMm * scaleAt(i))),
                          std::numeric_limits<float>::infinity());
  };
  std::vector<float> edges;
  for (int i = 0; i <= kSteps; ++i)
    edges.insert(edges.end(), {low(i), beyond(i)});
  std::sort(edges.begin(), edges.end());
  const std::vector<std::size_t> below = numberBelow(slope, edges);
  const auto share = [&](int i) {
    const auto belowEdge = [&](float edge) {
      return below[static_cast<std::size_t>(std::lower_bound(edges.begin(), edges.end(), edge) -
                                            edges.begin())];
    };
    return static_cast<double>(belowEdge(beyond(i)) - belowEdge(low(i))) /
           static_cast<double>(slope.size());
  };
  double maximum = 0.0;
  for (int i = 0; i <= kSteps; ++i)
    maximum = std::max(maximum, share(i));
  int chosen = 0;
  while (share(chosen) < maximum - kMinGain)
    ++chosen;
  if (within)
    *within = share(chosen);
  return scaleAt(chosen);
}

namespace {

// Computes the share and depth of the inaccessible voxels: their centre is more than half a cell
// inside the hull of the platform and all voxels of earlier levels, and the head does not reach
// them. spacing: height of a level in units of `field`, > 0.
void scoreAccess(const VoxelGraph& graph, const std::vector<float>& field,
                 const std::vector<Eigen::Vector3f>& gradient, double spacing,
                 const process::HeadShape* head, FieldScore& score, std::vector<std::int32_t>& deep,
                 const base::RunContext& ctx) {
  std::vector<std::int32_t> level(graph.size());
  for (std::size_t v = 0; v < graph.size(); ++v)
    level[v] = static_cast<std::int32_t>(std::floor(field[v] / spacing));
  const VoxelsByLevel byLevel(level);
  ConvexFront front(graph, ConvexFront::Columns::None);
  std::optional<NozzleReach> reach;
  if (head != nullptr)
    reach.emplace(graph, *head);
  deep.clear();
  std::size_t inaccessible = 0, hint = 0;
  for (std::size_t l = 0; l < byLevel.levels(); ++l) {
    ctx.checkpoint();
    for (const std::int32_t at : byLevel.of(l)) {
      const auto v = static_cast<std::size_t>(at);
      if (!front.deeperThan(v, 0.5, hint))
        continue;
      if (reach && reach->direction(v, gradient[v].cast<double>()))
        continue;
      ++inaccessible;
      const double depth = front.depth(v);
      score.deepest = std::max(score.deepest, depth);
      if (depth > 1.0)
        deep.push_back(at);
    }
    for (const std::int32_t v : byLevel.of(l)) {
      front.insert(static_cast<std::size_t>(v));
      if (reach)
        reach->insert(static_cast<std::size_t>(v));
    }
    front.rebuild();
  }
  score.inaccessible = static_cast<double>(inaccessible) / static_cast<double>(graph.size());
}

} // namespace

FieldScore scoreField(const VoxelGraph& graph, const std::vector<float>& field,
                      const std::vector<Eigen::Vector3f>& normals, const LayerLimits& limits,
                      const process::HeadShape* head, std::vector<std::int32_t>& deep,
                      const base::RunContext& ctx) {
  const std::vector<Eigen::Vector3f> gradient = fieldGradient(graph, field, ctx);
  std::vector<float> slope(gradient.size());
  std::size_t surface = 0, leaning = 0;
  for (std::size_t v = 0; v < gradient.size(); ++v) {
    slope[v] = gradient[v].norm();
    if (normals[v] == Eigen::Vector3f::Zero())
      continue;
    ++surface;
    leaning += gradient[v].dot(normals[v]) < -0.8660f * slope[v];
  }
  FieldScore score;
  score.scale = bestScale(slope, limits, &score.within);
  score.overhang = surface > 0 ? static_cast<double>(leaning) / static_cast<double>(surface) : 0.0;
  score.roofs = static_cast<double>(leaning) / static_cast<double>(graph.size());
  scoreAccess(graph, field, gradient, limits.heightMm / (score.scale * graph.grid.pitch), head,
              score, deep, ctx);
  return score;
}

} // namespace voluta::curved
