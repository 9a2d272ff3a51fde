#include "window/kind_statistics.h"

#include "process/bead_to.h"

#include <algorithm>

namespace voluta::window {

namespace {
double volumeTo(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t i,
                double lengthMm) {
  if (path.kind == plan::PathKind::Tape) // A flat ribbon
    return static_cast<double>(plan.widthMm[i]) * static_cast<double>(plan.heightMm[i]) * lengthMm;
  return process::beadTo(plan, i);
}

KindFigures figuresOf(const plan::ToolPlan& plan, const plan::ToolPath& path,
                      const process::Tooling& tooling, const timeline::Clock* clock) {
  KindFigures figures;
  double mm3 = 0.0;
  const bool isShot = path.kind == plan::PathKind::Shot;
  for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
    const double length = (plan.position[i] - plan.position[i - 1]).norm();
    figures.lengthMm += length;
    if (!isShot)
      mm3 += volumeTo(plan, path, i, length);
  }
  if (isShot)
    mm3 = plan.shotMm3(path);
  figures.massG = 1e-3 * mm3 * tooling.of(path).process.material.densityGPerCm3;
  if (clock && path.count > 0) {
    const auto from = clock->timeOfWaypoint(path.first);
    const auto to = clock->timeOfWaypoint(path.first + path.count - 1);
    if (from && to)
      figures.timeS = std::max(0.0, *to - *from);
  }
  return figures;
}

void add(KindFigures& to, const KindFigures& figures) {
  to.timeS += figures.timeS;
  to.lengthMm += figures.lengthMm;
  to.massG += figures.massG;
}
} // namespace

KindFigures KindStatistics::total() const {
  KindFigures all;
  for (const KindFigures& kind : kinds)
    add(all, kind);
  all.timeS += travelS;
  return all;
}

PrintStatistics printStatistics(const plan::ToolPlan& plan, const process::Tooling& tooling,
                                const timeline::Clock* clock) {
  const timeline::Clock* timing = clock && !clock->empty() ? clock : nullptr;
  PrintStatistics statistics;
  statistics.whole.timed = timing != nullptr;
  for (const plan::ToolPath& path : plan.paths) {
    const KindFigures figures = figuresOf(plan, path, tooling, timing);
    const auto kind = static_cast<std::size_t>(path.kind);
    add(statistics.whole.kinds[kind], figures);
    const auto layer = static_cast<std::size_t>(std::max(0, path.layer));
    if (statistics.layers.size() <= layer)
      statistics.layers.resize(layer + 1);
    statistics.layers[layer].timed = timing != nullptr;
    add(statistics.layers[layer].kinds[kind], figures);
  }
  if (timing)
    statistics.whole.travelS = std::max(0.0, timing->durationS() - statistics.whole.total().timeS);
  return statistics;
}

} // namespace voluta::window
