// Records a finished stage in its job: its key, its findings and its timings.
#pragma once

#include "plan/finding.h"
#include "project/job_stage.h"
#include "project/report.h"

#include <string>

namespace voluta::project {
struct Job;
}

namespace voluta::pipeline {

// Adds findings and timings of the stage to the job's report; the stage is then the last one of the
// job. In a job of several items, findings of stages after Load name the item in whose box, widened
// by `marginMm`, they lie (nameItems). `key`: empty for a stage that ended early. Findings on thin
// places are settled by those of replay.
void recordStage(project::Job& job, project::Stage stage, std::string key,
                 const plan::Findings& findings, const project::Timings& timings, double marginMm);

} // namespace voluta::pipeline
