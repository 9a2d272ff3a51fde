#include "pipeline/stage_record.h"

#include "pipeline/items/plate_parts.h"
#include "project/job.h"

#include <span>
#include <utility>

namespace voluta::pipeline {

void recordStage(project::Job& job, project::Stage stage, std::string key,
                 const plan::Findings& findings, const project::Timings& timings, double marginMm) {
  job.stages[project::indexOf(stage)] = {std::move(key), findings.size(), timings};
  plan::Findings& all = job.report.findings;
  all.insert(all.end(), findings.begin(), findings.end());
  if (job.items.size() > 1 && stage > project::Stage::Load)
    nameItems(std::span(all).last(findings.size()), job.items, marginMm);
  job.report.timings += timings;
  job.reached = stage;
}

} // namespace voluta::pipeline
