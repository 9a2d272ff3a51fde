#include "document/dated_findings.h"

#include "curved/decomposition.h"
#include "document/document.h"
#include "document/stage_at.h"

namespace voluta::document {

using project::indexOf;
using project::Stage;

namespace {
// Returns the findings of one stage among those of the whole plan.
plan::Findings findingsOf(const pipeline::PlanResult& result, Stage stage) {
  std::size_t before = 0;
  for (std::size_t s = 0; s < indexOf(stage); ++s)
    before += result.job.stages[s].findings;
  const plan::Findings& all = result.job.report.findings;
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(before);
  return {first, first + static_cast<std::ptrdiff_t>(result.job.stages[indexOf(stage)].findings)};
}
} // namespace

std::vector<DatedFinding> datedFindings(const Document& document) {
  std::vector<DatedFinding> all;
  const auto add = [&](const plan::Findings& findings, bool outOfDate) {
    for (const plan::Finding& finding : findings)
      all.push_back({finding, outOfDate});
  };
  for (std::size_t s = 0; s < project::kStageCount; ++s) {
    const Stage stage = stageAt(s);
    if (stage == Stage::Decompose && document.preview())
      add(document.preview()->decomposition->findings, false);
    else if (const auto result = document.result(stage))
      add(findingsOf(*result, stage), !document.upToDate(stage));
  }
  return all;
}

std::vector<Stage> uncheckedStages(const Document& document) {
  std::vector<Stage> unchecked;
  for (std::size_t s = 0; s < project::kStageCount; ++s)
    if (!document.upToDate(stageAt(s)))
      unchecked.push_back(stageAt(s));
  return unchecked;
}

} // namespace voluta::document
