#include "toolpath/slow_to_cool.h"

#include "collision/bead_samples.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace voluta::toolpath {

namespace {
using collision::BeadSample, collision::BeadSampleGrid;

// Segments of beads, by the waypoints at their ends, that are printed in `share` of the time that
// they should take.
struct HastySpan {
  std::size_t first = 0, last = 0;
  double share = 1.0;
};

double secondsTo(const plan::ToolPlan& plan, std::size_t waypoint) {
  return (plan.position[waypoint] - plan.position[waypoint - 1]).norm() /
         static_cast<double>(plan.speedMmPerS[waypoint]);
}

// Returns the spans in the order of their shares.
std::vector<HastySpan> hastySpans(const plan::ToolPlan& plan, double minS) {
  std::vector<HastySpan> spans;
  BeadSampleGrid grid(plan);
  std::vector<double> endS; // per sample
  std::vector<std::size_t> waypointOf;
  std::vector<BeadSample> samples;
  double now = 0.0;
  for (const plan::ToolPath& path : plan.paths) {
    if (plan::isWaste(path.kind))
      continue;
    for (std::size_t w = path.first + 1; w < path.first + path.count; ++w) {
      const double seconds = secondsTo(plan, w);
      samples.clear();
      collision::appendSamples(plan, w - 1, w, samples);
      for (const BeadSample& sample : samples) {
        std::size_t latest = endS.size();
        grid.below(sample, [&](std::size_t lower) {
          latest = latest == endS.size() ? lower : std::max(latest, lower);
        });
        const double begin = now + sample.from * seconds;
        if (latest < endS.size() && begin - endS[latest] < minS)
          spans.push_back({waypointOf[latest], w, std::max(0.0, (begin - endS[latest]) / minS)});
        grid.add(sample);
        endS.push_back(now + sample.to * seconds);
        waypointOf.push_back(w);
      }
      now += seconds;
    }
  }
  std::ranges::stable_sort(spans, {}, &HastySpan::share);
  return spans;
}

// Returns per waypoint the least share of the spans that contain it; 1 where there is none.
std::vector<double> minShares(const std::vector<HastySpan>& spans, std::size_t waypoints) {
  std::vector<double> shares(waypoints, 1.0);
  std::vector<std::size_t> next(waypoints + 1); // waypoint without a share, at or behind this one
  std::iota(next.begin(), next.end(), std::size_t{0});
  const auto open = [&](std::size_t w) {
    while (next[w] != w)
      w = next[w] = next[next[w]];
    return w;
  };
  for (const HastySpan& span : spans)
    for (std::size_t w = open(span.first); w <= span.last; w = open(w)) {
      shares[w] = span.share;
      next[w] = w + 1;
    }
  return shares;
}
} // namespace

void slowToCool(plan::ToolPlan& plan, const CoolingOptions& options) {
  if (options.minLayerTimeS <= 0.0 || options.slowestMmPerS <= 0.0)
    return;
  const std::vector<double> shares =
      minShares(hastySpans(plan, options.minLayerTimeS), plan.waypointCount());
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t w = path.first; w < path.first + path.count && !plan::isWaste(path.kind);
         ++w) {
      const auto speed = static_cast<double>(plan.speedMmPerS[w]);
      plan.speedMmPerS[w] =
          static_cast<float>(std::min(speed, std::max(shares[w] * speed, options.slowestMmPerS)));
    }
}

} // namespace voluta::toolpath
