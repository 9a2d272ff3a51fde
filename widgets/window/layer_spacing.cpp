#include "window/layer_spacing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::window {

namespace {
constexpr int kBins = 36;
constexpr double kBeyond = 0.15;  // Of the limits' span, on either side
constexpr double kSlackMm = 1e-6; // Tolerance of the limits
} // namespace

LayerSpacing layerSpacing(const layers::LayerStack& stack, const scene::HeightLimits& heights) {
  LayerSpacing spacing;
  spacing.heights = heights;
  if (!heights.known())
    return spacing;
  const double beyond = kBeyond * (heights.maxMm - heights.minMm);
  spacing.lowMm = std::max(0.0, heights.minMm - beyond);
  spacing.highMm = heights.maxMm + beyond;
  std::vector<double> area(kBins, 0.0);
  double total = 0.0, volume = 0.0, thinner = 0.0, thicker = 0.0;
  for (const layers::Patch& patch : stack.patches)
    for (std::size_t t = 0; t < patch.surface.triangles.size(); ++t) {
      const Eigen::Vector3d a = patch.surface.corner(t, 0);
      const double one =
          0.5 * (patch.surface.corner(t, 1) - a).cross(patch.surface.corner(t, 2) - a).norm();
      double thickness = 0.0;
      for (const int v : patch.surface.triangles[t])
        thickness += patch.thicknessMm[static_cast<std::size_t>(v)] / 3.0;
      const double place = (thickness - spacing.lowMm) / (spacing.highMm - spacing.lowMm) * kBins;
      area[static_cast<std::size_t>(std::clamp(static_cast<int>(place), 0, kBins - 1))] += one;
      total += one;
      volume += one * thickness;
      thinner += thickness < heights.minMm - kSlackMm ? one : 0.0;
      thicker += thickness > heights.maxMm + kSlackMm ? one : 0.0;
    }
  if (total <= 0.0)
    return spacing;
  for (double& one : area)
    one /= total;
  spacing.shares = std::move(area);
  spacing.meanMm = volume / total;
  spacing.thinner = thinner / total;
  spacing.thicker = thicker / total;
  spacing.within = 1.0 - spacing.thinner - spacing.thicker;
  return spacing;
}

} // namespace voluta::window
