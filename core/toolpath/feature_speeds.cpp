#include "toolpath/feature_speeds.h"

#include "base/error.h"
#include "base/index.h"
#include "process/bead_model.h"

#include <algorithm>
#include <utility>

namespace voluta::toolpath {

namespace {
using base::at;
using plan::PathKind;
using process::Feature;
using process::FeatureSettings;

double widthOf(const layers::Patch& patch, const process::Process& process, bool isFirstLayer) {
  const double first = process.features.of(Feature::FirstLayer).widthMm;
  if (isFirstLayer && first > 0.0)
    return first;
  const double support = process.features.of(Feature::Support).widthMm;
  if (patch.group == layers::kSupportGroup && support > 0.0)
    return support;
  return process.beadWidthMm;
}

// The settings of one path.
struct PathSettings {
  double speedMmPerS = 0.0; // 0: none
  double flow = 1.0, bridgeFlow = 1.0;

  bool change() const { return speedMmPerS > 0.0 || flow != 1.0 || bridgeFlow != 1.0; }
};

PathSettings settingsOf(const plan::ToolPath& path, const process::Process& process,
                        bool isFirstLayer) {
  PathSettings settings;
  const auto add = [&](const FeatureSettings& of) {
    if (of.speedMmPerS > 0.0)
      settings.speedMmPerS = of.speedMmPerS;
    settings.flow *= of.flow;
  };
  if (path.kind == PathKind::Prime)
    return settings;
  if (!plan::isWaste(path.kind)) {
    add(process.features.of(featureOf(path)));
    settings.bridgeFlow = process.features.of(Feature::Bridge).flow;
  }
  if (isFirstLayer)
    add(process.features.of(Feature::FirstLayer));
  return settings;
}

// Changes one path. Returns whether a width has changed.
class PathChange {
public:
  PathChange(plan::ToolPlan& plan, const plan::ToolPath& path, const process::Process& process,
             const std::vector<char>& unsupported)
      : plan_(plan), path_(path), process_(process), unsupported_(unsupported) {}

  bool scaleWidths(const PathSettings& settings) {
    bool changed = false;
    for (std::size_t i = path_.first; i < end(); ++i) {
      // A closed path has the same bead at both of its ends.
      const std::size_t of = path_.closed && i + 1 == end() ? path_.first : i;
      const double flow = unsupported_[of] ? settings.bridgeFlow : settings.flow;
      if (flow == 1.0)
        continue;
      const double height = plan_.heightMm[i], width = plan_.widthMm[i];
      const double wanted = process::widthOfArea(flow * process::beadArea(width, height), height);
      // Widths beyond the limits, such as those of thin supports, do not move away from them.
      const double minimum = std::max(height, std::min(process_.beadWidthMinMm, width)),
                   maximum = std::max({process_.beadWidthMaxMm, width, minimum});
      const auto now = static_cast<float>(std::clamp(wanted, minimum, maximum));
      changed = changed || now != plan_.widthMm[i];
      plan_.widthMm[i] = now;
    }
    return changed;
  }

  void setSpeeds(double speedMmPerS) {
    double last = 0.0; // section
    for (std::size_t i = path_.first; i < end(); ++i) {
      const double own = process::beadArea(plan_.widthMm[i], plan_.heightMm[i]);
      // As in assemble(): while the section decreases, more is extruded than at the end point.
      const double section = std::max(own, std::exchange(last, own));
      double speed = std::min(speedMmPerS, process::flowLimit(process_) / section);
      if (unsupported_[i] || (i > path_.first && unsupported_[i - 1]))
        speed = std::min(speed, process_.bridgeSpeedMmPerS);
      plan_.speedMmPerS[i] = static_cast<float>(speed);
    }
  }

private:
  std::size_t end() const { return path_.first + path_.count; }

  plan::ToolPlan& plan_;
  const plan::ToolPath& path_;
  const process::Process& process_;
  const std::vector<char>& unsupported_;
};

} // namespace

Feature featureOf(const plan::ToolPath& path) {
  switch (path.kind) {
  case PathKind::Wall:
    return path.ring == 0 ? Feature::OuterWall : Feature::InnerWall;
  case PathKind::Support:
    return Feature::Support;
  case PathKind::SparseInfill:
    return Feature::SparseInfill;
  default:
    return Feature::Infill;
  }
}

process::Process processOf(const layers::Patch& patch, const process::Tooling& tooling,
                           bool isFirstLayer) {
  process::Process process = tooling.at(patch.tool).process;
  process.beadWidthMm = widthOf(patch, process, isFirstLayer);
  return process;
}

void setWallWidths(const layers::LayerStack& stack, const process::Tooling& tooling,
                   const std::vector<char>& isFirstLayer,
                   std::vector<std::vector<double>>& wallWidths) {
  base::require(wallWidths.size() == stack.patches.size() &&
                    isFirstLayer.size() == stack.patches.size(),
                "widths and a mark per patch");
  for (std::size_t p = 0; p < stack.patches.size(); ++p) {
    const layers::Patch& patch = stack.patches[p];
    const process::Process& process = tooling.at(patch.tool).process;
    if (widthOf(patch, process, isFirstLayer[p] != 0) != process.beadWidthMm) {
      wallWidths[p].clear();
      continue;
    }
    const double outer = process.features.of(Feature::OuterWall).widthMm;
    if (outer <= process.beadWidthMm || patch.group == layers::kSupportGroup)
      continue;
    wallWidths[p].resize(patch.surface.vertices.size(), process.beadWidthMm);
    for (std::size_t v = 0; v < wallWidths[p].size(); ++v)
      if (patch.innerRim.empty() || !patch.innerRim[v])
        wallWidths[p][v] = std::max(wallWidths[p][v], outer);
  }
}

bool applyFeatures(plan::ToolPlan& plan, const process::Tooling& tooling,
                   const std::vector<char>& isFirstLayer, const std::vector<char>& unsupported) {
  base::require(unsupported.size() == plan.waypointCount(), "a mark for each waypoint");
  bool changed = false;
  for (const plan::ToolPath& path : plan.paths) {
    const process::Process& process = tooling.of(path).process;
    const PathSettings settings = settingsOf(path, process, isFirstLayer[at(path.patch)] != 0);
    if (!settings.change())
      continue;
    PathChange change(plan, path, process, unsupported);
    changed = change.scaleWidths(settings) || changed;
    change.setSpeeds(settings.speedMmPerS > 0.0 ? settings.speedMmPerS : process.speedMmPerS);
  }
  return changed;
}

void scaleSpeeds(plan::ToolPlan& plan, const process::Tooling& tooling,
                 const std::function<double(const plan::ToolPath&)>& factorOf,
                 const std::vector<char>& unsupported) {
  base::require(unsupported.size() == plan.waypointCount(), "a mark for each waypoint");
  for (const plan::ToolPath& path : plan.paths) {
    if (path.kind == PathKind::Support || plan::isWaste(path.kind))
      continue;
    const double factor = factorOf(path);
    if (factor == 1.0)
      continue;
    const process::Process& process = tooling.of(path).process;
    double last = 0.0; // section
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      const double own = process::beadArea(plan.widthMm[i], plan.heightMm[i]);
      const double section = std::max(own, std::exchange(last, own)); // As in setSpeeds()
      const double before = plan.speedMmPerS[i];
      double speed =
          std::min(factor * before, std::max(before, process::flowLimit(process) / section));
      if (unsupported[i] || (i > path.first && unsupported[i - 1]))
        speed = std::min(speed, std::max(before, process.bridgeSpeedMmPerS));
      plan.speedMmPerS[i] = static_cast<float>(speed);
    }
  }
}

} // namespace voluta::toolpath
