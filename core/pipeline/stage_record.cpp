#include "pipeline/stage_record.h"

#include "pipeline/items/plate_parts.h"
#include "plan/finding_kinds.h"
#include "project/job.h"

#include <algorithm>
#include <span>
#include <utility>

namespace voluta::pipeline {

namespace {
bool isOfThinPart(const plan::Finding& finding) {
  return finding.kind == plan::FindingKind::ThinPart ||
         finding.kind == plan::FindingKind::ThinPartInReach;
}

// Replay measures what beads make of thin places: earlier findings on them do not block a part that
// it finds printed as asked, and are removed where it reports such places itself.
void settleThin(project::Job& job) {
  using enum plan::FindingKind;
  plan::Findings& all = job.report.findings;
  const project::ReplayReport& replay = job.report.replay;
  if (replay.passed)
    for (plan::Finding& finding : all)
      if (isOfThinPart(finding) || (finding.kind == PatchWithoutBead && replay.thinMm3 > 0.0))
        finding.blocking = false;
  if (std::ranges::none_of(all, [](const plan::Finding& finding) {
        return finding.kind == Thin || finding.kind == GivenThin;
      }))
    return;
  std::size_t first = 0;
  for (project::StageRecord& record : job.stages) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first),
               end = begin + static_cast<std::ptrdiff_t>(record.findings);
    const auto kept = std::remove_if(begin, end, [](const plan::Finding& finding) {
      return isOfThinPart(finding) || finding.kind == ThinWallsLeftOut ||
             finding.kind == PatchWithoutBead;
    });
    record.findings = static_cast<std::size_t>(kept - begin);
    all.erase(kept, end);
    first += record.findings;
  }
}
} // namespace

void recordStage(project::Job& job, project::Stage stage, std::string key,
                 const plan::Findings& findings, const project::Timings& timings, double marginMm) {
  job.stages[project::indexOf(stage)] = {std::move(key), findings.size(), timings};
  plan::Findings& all = job.report.findings;
  all.insert(all.end(), findings.begin(), findings.end());
  if (job.items.size() > 1 && stage > project::Stage::Load)
    nameItems(std::span(all).last(findings.size()), job.items, marginMm);
  if (stage == project::Stage::Replay)
    settleThin(job);
  job.report.timings += timings;
  job.reached = stage;
}

} // namespace voluta::pipeline
