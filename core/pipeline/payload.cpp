#include "pipeline/payload.h"

#include "plan/finding_kinds.h"

namespace voluta::pipeline {

std::optional<plan::Finding> overload(const robot::Cell& cell, double materialG) {
  constexpr double kNearly = 0.9, kKgPerGram = 1e-3;
  const std::optional<double>& most = cell.robot().payloadKg;
  const double material = cell.nozzleMount() == robot::Mount::World ? materialG * kKgPerGram : 0.0;
  const double carried = cell.carriedKg() + material;
  if (!most || carried <= kNearly * *most)
    return std::nullopt;
  plan::Finding finding =
      plan::makeFinding(plan::FindingKind::Overload, {{"carried", base::number(carried)},
                                                      {"material", base::number(material)},
                                                      {"most", base::number(*most)}});
  finding.blocking = carried > *most;
  return finding;
}

} // namespace voluta::pipeline
