#include "pipeline/payload.h"

#include "geometry/measures.h"
#include "pipeline/plan_result.h"
#include "pipeline/resolved.h"
#include "plan/finding_kinds.h"

#include <cmath>

namespace voluta::pipeline {

std::optional<plan::Finding> overload(const robot::Cell& cell, double materialG) {
  constexpr double kNearly = 0.9, kKgPerGram = 1e-3;
  const std::optional<double>& maximum = cell.robot().payloadKg;
  const double material = cell.nozzleMount() == robot::Mount::World ? materialG * kKgPerGram : 0.0;
  const double carried = cell.carriedKg() + material;
  if (!maximum || carried <= kNearly * *maximum)
    return std::nullopt;
  plan::Finding finding =
      plan::makeFinding(plan::FindingKind::Overload, {{"carried", base::number(carried)},
                                                      {"material", base::number(material)},
                                                      {"most", base::number(*maximum)}});
  finding.blocking = carried > *maximum;
  return finding;
}

double solidKg(const PlanResult& result) {
  constexpr double kKgPerMm3 = 1e-6; // at 1 g/cm³
  double kg = 0.0;
  for (std::size_t i = 0; i < result.job.items.size(); ++i)
    if (const auto& part = result.job.item(i).part)
      kg += kKgPerMm3 * result.item(i).resolved->process().material.densityGPerCm3 *
            std::abs(geometry::volume(*part));
  return kg;
}

} // namespace voluta::pipeline
