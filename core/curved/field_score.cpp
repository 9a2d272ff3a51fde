#include "curved/field_score.h"

#include "base/error.h"
#include "curved/convex_front.h"
#include "curved/field_fit.h"
#include "curved/nozzle_reach.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace voluta::curved {

double bestScale(const std::vector<float>& slope, const LayerLimits& limits, double* within) {
  base::require(!slope.empty(), "bestScale: a voxel or more");
  std::vector<float> sorted = slope;
  std::sort(sorted.begin(), sorted.end());
  const auto share = [&](double scale) {
    // Thickness h / (scale slope) within [min, max].
    const auto low = static_cast<float>(limits.heightMm / (limits.maxMm * scale));
    const auto high = static_cast<float>(limits.heightMm / (limits.minMm * scale));
    const auto first = std::lower_bound(sorted.begin(), sorted.end(), low);
    const auto last = std::upper_bound(first, sorted.end(), high);
    return static_cast<double>(last - first) / static_cast<double>(sorted.size());
  };
  const double median = std::max(1e-3f, sorted[sorted.size() / 2]);
  // From the nominal height at the median to the least height there.
  const double nominal = 1.0 / median;
  constexpr int kSteps = 60;
  constexpr double kLeastGain =
      1e-3; // share of voxels that a height further from nominal must save
  const auto scaleAt = [&](int i) {
    return nominal * std::pow(limits.heightMm / limits.minMm, i / double{kSteps});
  };
  double most = 0.0;
  for (int i = 0; i <= kSteps; ++i)
    most = std::max(most, share(scaleAt(i)));
  int chosen = 0;
  while (share(scaleAt(chosen)) < most - kLeastGain)
    ++chosen;
  const double best = scaleAt(chosen), bestShare = share(best);
  if (within)
    *within = bestShare;
  return best;
}

namespace {

// Voxels whose centre lies deeper than half a cell inside the hull of the platform and all voxels
// of earlier levels, and that the head does not reach: their share and depth. spacing: height of a
// level in units of `field`, > 0.
void scoreAccess(const VoxelGraph& graph, const std::vector<float>& field,
                 const std::vector<Eigen::Vector3f>& gradient, double spacing,
                 const process::HeadShape* head, FieldScore& score, std::vector<std::int32_t>& deep,
                 const base::RunContext& ctx) {
  std::vector<std::int32_t> order(graph.size());
  std::iota(order.begin(), order.end(), 0);
  const auto level = [&](std::int32_t v) {
    return static_cast<int>(std::floor(field[static_cast<std::size_t>(v)] / spacing));
  };
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    const int la = level(a), lb = level(b);
    return la != lb ? la < lb : a < b;
  });
  ConvexFront front(graph);
  std::optional<NozzleReach> reach;
  if (head != nullptr)
    reach.emplace(graph, *head);
  deep.clear();
  std::size_t inaccessible = 0, hint = 0;
  for (std::size_t begin = 0; begin < order.size();) {
    ctx.checkpoint();
    std::size_t end = begin;
    for (; end < order.size() && level(order[end]) == level(order[begin]); ++end) {
      const auto v = static_cast<std::size_t>(order[end]);
      if (!front.deeperThan(v, 0.5, hint))
        continue;
      if (reach && reach->direction(v, gradient[v].cast<double>()))
        continue;
      ++inaccessible;
      const double depth = front.depth(v);
      score.deepest = std::max(score.deepest, depth);
      if (depth > 1.0)
        deep.push_back(order[end]);
    }
    for (std::size_t i = begin; i < end; ++i) {
      front.insert(static_cast<std::size_t>(order[i]));
      if (reach)
        reach->insert(static_cast<std::size_t>(order[i]));
    }
    front.rebuild();
    begin = end;
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
