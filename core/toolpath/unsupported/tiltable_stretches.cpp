#include "toolpath/unsupported/tiltable_stretches.h"

#include <algorithm>

namespace voluta::toolpath {

using Eigen::Vector3d;

bool isUpright(const plan::ToolPlan& plan) {
  // Supports tilt where the head would collide, and can be left out.
  return std::ranges::all_of(plan.paths, [&](const plan::ToolPath& path) {
    const auto first = plan.direction.begin() + static_cast<std::ptrdiff_t>(path.first);
    return path.kind == plan::PathKind::Support ||
           std::all_of(first, first + static_cast<std::ptrdiff_t>(path.count),
                       [](const Vector3d& d) { return d == Vector3d::UnitZ(); });
  });
}

std::vector<UnsupportedStretch> tiltableStretches(const plan::ToolPlan& plan,
                                                  const plan::ToolPath& path,
                                                  const std::vector<char>& unsupported,
                                                  const process::Tooling& tooling) {
  if (path.kind == plan::PathKind::Support)
    return {};
  const process::Process& process = tooling.of(path).process;
  std::vector<UnsupportedStretch> stretches =
      unsupportedStretches(plan, path, unsupported, 0.5 * process.bridgeMm);
  // The ends of a spiral are thinner than layers and lie on the turn below, but the cells of the
  // part are too coarse for that.
  std::erase_if(stretches, [&](const UnsupportedStretch& s) {
    const auto height = plan.heightMm.begin();
    return std::all_of(height + static_cast<std::ptrdiff_t>(s.begin),
                       height + static_cast<std::ptrdiff_t>(s.end),
                       [&](float h) { return static_cast<double>(h) < process.layerHeightMinMm; });
  });
  return stretches;
}

} // namespace voluta::toolpath
