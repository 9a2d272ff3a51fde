// A program's text back through its reader and the second opinion.
#pragma once

#include "base/run_context.h"
#include "pipeline/job.h"
#include "pipeline/report.h"
#include "plan/program.h"
#include "process/process.h"
#include "replay/verification.h"
#include "robot/cell.h"

#include <string>
#include <vector>

namespace voluta::pipeline {

// Reads `files` as `format` and replays them. Preconditions: the job holds ToolPlan and Trajectory.
replay::Verification replayText(const std::string& format,
                                const std::vector<plan::ProgramFile>& files, const Job& job,
                                const robot::Cell& cell, const process::Process& process,
                                const base::RunContext& ctx);

ReplayReport replayReport(const replay::Verification& verdict);

// "coveredFraction 0.9512 (limit 0.97), ..." of what failed; "passed" when nothing did.
std::string failedThresholds(const replay::Verification& verdict);

} // namespace voluta::pipeline
