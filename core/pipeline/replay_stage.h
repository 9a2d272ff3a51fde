// A program's text back through its reader and the second opinion.
#pragma once

#include "base/run_context.h"
#include "pipeline/stages.h"
#include "plan/program.h"
#include "program/job_head.h"
#include "program/merged_points.h"
#include "project/report.h"
#include "replay/verification.h"

#include <cstddef>
#include <string>
#include <vector>

namespace voluta::pipeline {

// Of motions behind those of what was printed before, of no line.
struct ReadBack {
  std::size_t firstMotion = 0; // of the text
  std::vector<plan::ProgramDefect> defects;
  replay::Verification verdict;
};

// The same with these points in place of the trajectory's: what a dialect says of it
// (program::pointsFor), and the job's hash as it is without. The caller keeps them alive.
ProgramStageInput saying(const ProgramStageInput& in, const program::MergedPoints& points);

// What a job's programs and what lies beside them are called: as the part; the rest of a print that
// is taken up again apart from the first.
std::string programsName(const project::Job& job);

// What the head of a program says that is written from these (the points of its dialect: saying).
program::JobHead headOf(const ProgramStageInput& said);

// Reads `files` as `format` and replays them against what they were written from. `judged`: as
// replay::replayProgram takes it.
ReadBack replayText(const std::string& format, const std::vector<plan::ProgramFile>& files,
                    const ProgramStageInput& planned, const base::RunContext& ctx,
                    replay::JudgedRuns* judged = nullptr);

project::ReplayReport replayReport(const replay::Verification& verdict);

// "coveredFraction 0.9512 (limit 0.97)" and the like, of what failed.
std::vector<base::Message> failedThresholds(const replay::Verification& verdict);

// Puts what a program came to into the report and its findings. The first program, the cell's own
// unless the user chose others only, carries the verdict; one that does not decide, for another
// controller, is only told where it is refused.
void tellProgram(const CheckedProgram& checked, bool first, bool decides, project::Report& report,
                 plan::Findings& findings);

} // namespace voluta::pipeline
