#include "window/layer_measures.h"

#include <algorithm>
#include <limits>

namespace voluta::window {

namespace {
void addPatch(panels::LayerMeasures& m, const layers::Patch& patch) {
  const auto& vertices = patch.surface.vertices;
  ++m.patches;
  for (const auto& t : patch.surface.triangles) {
    const auto at = [&](int i) { return static_cast<std::size_t>(t[static_cast<std::size_t>(i)]); };
    const double area =
        0.5 * (vertices[at(1)] - vertices[at(0)]).cross(vertices[at(2)] - vertices[at(0)]).norm();
    double thickness = 0.0;
    for (int i = 0; i < 3; ++i)
      thickness += patch.thicknessMm[at(i)] / 3.0;
    m.areaMm2 += area;
    m.thicknessMeanMm += area * thickness; // Divided by the area at the end
  }
  for (const double thickness : patch.thicknessMm) {
    m.thicknessMinMm = std::min(m.thicknessMinMm, thickness);
    m.thicknessMaxMm = std::max(m.thicknessMaxMm, thickness);
  }
}

void addPath(panels::LayerMeasures& m, const plan::ToolPlan& plan, const plan::ToolPath& path,
             const timeline::Clock* clock) {
  m.waypoints += path.count;
  for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
    m.lengthMm += (plan.position[i] - plan.position[i - 1]).norm();
  if (!clock || clock->empty() || path.count == 0)
    return;
  const auto from = clock->timeOfWaypoint(path.first);
  const auto to = clock->timeOfWaypoint(path.first + path.count - 1);
  if (from && to)
    m.timeS += *to - *from;
}
} // namespace

std::vector<panels::LayerMeasures> layerMeasures(const layers::LayerStack& stack,
                                                 const plan::ToolPlan* plan,
                                                 const timeline::Clock* clock) {
  std::vector<panels::LayerMeasures> measures(static_cast<std::size_t>(stack.layerCount));
  for (std::size_t i = 0; i < measures.size(); ++i) {
    measures[i].index = static_cast<int>(i);
    measures[i].layers = stack.layerCount;
    measures[i].thicknessMinMm = std::numeric_limits<double>::infinity();
  }
  for (const layers::Patch& patch : stack.patches)
    if (patch.layer >= 0 && patch.layer < stack.layerCount)
      addPatch(measures[static_cast<std::size_t>(patch.layer)], patch);
  if (plan)
    for (const plan::ToolPath& path : plan->paths)
      if (path.layer >= 0 && path.layer < stack.layerCount)
        addPath(measures[static_cast<std::size_t>(path.layer)], *plan, path, clock);
  for (panels::LayerMeasures& m : measures) {
    if (m.areaMm2 > 0.0)
      m.thicknessMeanMm /= m.areaMm2;
    if (m.patches == 0)
      m.thicknessMinMm = 0.0;
  }
  return measures;
}

std::vector<double> layerTopsMm(const std::vector<panels::LayerMeasures>& measures) {
  std::vector<double> tops;
  double top = 0.0;
  for (const panels::LayerMeasures& m : measures)
    tops.push_back(top += m.thicknessMeanMm);
  return tops;
}

std::vector<double> layerRadiiMm(const layers::LayerStack& stack) {
  struct Sum {
    double radii = 0.0;
    std::size_t vertices = 0;
  };
  std::vector<Sum> sums(static_cast<std::size_t>(stack.layerCount));
  for (const layers::Patch& patch : stack.patches) {
    if (patch.chart.periodMm <= 0.0 || patch.layer < 0 || patch.layer >= stack.layerCount)
      continue;
    Sum& sum = sums[static_cast<std::size_t>(patch.layer)];
    for (std::size_t v = 0; v < patch.surface.vertices.size(); ++v)
      sum.radii += patch.surface.vertices[v].tail<2>().norm() + 0.5 * patch.thicknessMm[v];
    sum.vertices += patch.surface.vertices.size();
  }
  std::vector<double> radii;
  for (const Sum& sum : sums) {
    if (sum.vertices == 0)
      return {};
    radii.push_back(sum.radii / static_cast<double>(sum.vertices));
  }
  return radii;
}

} // namespace voluta::window
