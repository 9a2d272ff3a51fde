#include "pipeline/early_verdict.h"

#include "geometry/measures.h"
#include "plan/blocking_share.h"
#include "plan/finding_kinds.h"
#include "process/bead_to.h"
#include "replay/verification.h"

#include <cmath>

namespace voluta::pipeline {

namespace {

// Margin between the planned material and the figure that replay measures. In a replay the flow of
// a controller may deviate from the plan by up to 5 % over a bead without being counted, part of
// the bead length counts as it is, and the reference is the volume of the part or of its cells,
// which differ by at most 2 %.
constexpr double kLeeway = 0.08;

double partMaterial(const plan::ToolPlan& toolPlan) {
  double mm3 = 0.0;
  for (const plan::ToolPath& path : toolPlan.paths) {
    if (path.kind == plan::PathKind::Support || path.kind == plan::PathKind::Tape ||
        plan::isWaste(path.kind))
      continue;
    if (path.kind == plan::PathKind::Shot) {
      mm3 += toolPlan.shotMm3(path);
      continue;
    }
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      mm3 += process::beadTo(toolPlan, i);
  }
  return mm3;
}

} // namespace

std::optional<plan::Finding> massOutOfReach(const plan::ToolPlan& toolPlan,
                                            const geometry::TriangleMesh& part,
                                            const process::Process& process, double tolerance) {
  double volume = std::abs(geometry::volume(part));
  for (const plan::FillIntent& fill : toolPlan.fill)
    volume -= fill.openMm3;
  if (!(volume > 0.0))
    return std::nullopt;
  // Priming before each bead, with the nozzle at rest, adds material too.
  const double standing = static_cast<double>(toolPlan.paths.size()) * process.primeS *
                          process::flowLimit(process) / volume;
  const double ratio = partMaterial(toolPlan) / volume;
  const double slack = tolerance + kLeeway;
  if (ratio <= 1.0 + slack + plan::kBlockingShare && ratio + standing >= 1.0 - slack)
    return std::nullopt;
  return plan::makeFinding(plan::FindingKind::Mass, {{"share", base::percent(100.0 * ratio)}});
}

} // namespace voluta::pipeline
