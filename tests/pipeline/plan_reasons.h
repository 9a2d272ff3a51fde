// The reasons of a plan's findings, for failed expectations.
#pragma once

#include "pipeline/road.h"
#include "plan/finding_kinds.h"

#include <string>

namespace voluta::test {

// Returns the reasons in English, a line each.
inline std::string reasons(const pipeline::PlanResult& plan) {
  std::string all;
  for (const plan::Finding& finding : plan.job.report.findings)
    all += plan::englishReason(finding) + "\n";
  return all;
}

} // namespace voluta::test
