#include "toolpath/path_figures.h"

#include "base/units.h"
#include "geometry/directions.h"
#include "process/bead_to.h"

#include <algorithm>
#include <vector>

namespace voluta::toolpath {

namespace {
using plan::PathKind;
using process::Tape;

constexpr double kMm3PerCm3 = 1000.0;

double lengthTo(const plan::ToolPlan& plan, std::size_t waypoint) {
  return (plan.position[waypoint] - plan.position[waypoint - 1]).norm();
}

void setTapeFigures(const plan::ToolPlan& plan, const process::Tooling& tooling,
                    plan::ToolpathStatistics& s) {
  s.tapes = 0;
  s.tapeMm = s.tapeG = 0.0;
  std::vector<double> lengthMm(tooling.tools().size()), volumeMm3(lengthMm.size());
  for (const plan::ToolPath& path : plan.paths) {
    if (path.kind != PathKind::Tape)
      continue;
    ++s.tapes;
    const auto tool = static_cast<std::size_t>(path.tool);
    for (std::size_t w = path.first + 1; w < path.first + path.count; ++w) {
      const double length = lengthTo(plan, w);
      s.tapeMm += length;
      lengthMm.at(tool) += length;
      volumeMm3.at(tool) +=
          length * static_cast<double>(plan.widthMm[w]) * static_cast<double>(plan.heightMm[w]);
    }
  }
  for (std::size_t tool = 0; tool < lengthMm.size(); ++tool) {
    const process::Process& process = tooling.tools()[tool].process;
    const Tape* tape = process.tape ? &*process.tape : nullptr;
    // A file's tapes may be deposited by a tool that has none of its own.
    const double mm3 = tape ? lengthMm[tool] * tape->widthMm * tape->thicknessMm : volumeMm3[tool];
    s.tapeG += mm3 * process.material.densityGPerCm3 / kMm3PerCm3;
  }
}

} // namespace

void setPathFigures(const plan::ToolPlan& plan, std::size_t items, const process::Tooling& tooling,
                    plan::ToolpathStatistics& s) {
  s.items.assign(items > 1 ? items : 0, {});
  s.paths = s.starts = plan.paths.size();
  s.waypoints = plan.waypointCount();
  s.shots = 0;
  s.lengthMm = s.travelMm = s.materialMm3 = s.shotMm3 = 0.0;
  plan::ItemToolpaths ofOne;
  for (std::size_t k = 0; k < plan.paths.size(); ++k) {
    const plan::ToolPath& path = plan.paths[k];
    if (k > 0)
      s.travelMm += (plan.position[path.first] - plan.position[path.first - 1]).norm();
    if (path.kind == PathKind::Tape)
      continue;
    plan::ItemToolpaths& own = items > 1 ? s.items.at(static_cast<std::size_t>(path.item)) : ofOne;
    if (path.kind == PathKind::Shot) {
      const double mm3 = plan.shotMm3(path);
      ++s.shots;
      s.shotMm3 += mm3;
      s.materialMm3 += mm3;
      own.materialMm3 += mm3;
      continue;
    }
    own.paths += plan::isWaste(path.kind) ? 0 : 1;
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
      const double length = lengthTo(plan, i);
      s.lengthMm += length;
      if (plan::isWaste(path.kind))
        continue;
      const double mm3 = process::beadTo(plan, i);
      s.materialMm3 += mm3;
      own.lengthMm += length;
      own.materialMm3 += mm3;
    }
  }
  setTapeFigures(plan, tooling, s);
}

double maxRotationDeg(const plan::ToolPlan& plan) {
  double greatest = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      greatest = std::max(greatest, base::radiansToDegrees(geometry::angleBetween(
                                        plan.direction[i - 1], plan.direction[i])));
  return greatest;
}

} // namespace voluta::toolpath
