// Reads a program's text back and verifies it by replay; fills the report's program rows.
#pragma once

#include "base/run_context.h"
#include "pipeline/program_stage.h"
#include "plan/program.h"
#include "program/job_head.h"
#include "program/merged_points.h"
#include "project/report.h"
#include "replay/verification.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace voluta::project {
struct Job;
}

namespace voluta::pipeline {

struct Resolved;

// With Job::resumedAt, the motions of the part printed before precede those of the text; they have
// line 0.
struct ReadBack {
  std::size_t firstMotion = 0; // index of the text's first motion
  std::vector<plan::ProgramDefect> defects;
  std::uint64_t hash = 0; // of the text as read (program::readHash)
  replay::Verification verdict;
};

// Returns `in` with the dialect's merged points (program::pointsFor) in place of the trajectory's
// points, and with the hash of the job as it is without merging. The caller keeps `in` and `points`
// alive.
ProgramStageInput saying(const ProgramStageInput& in, const program::MergedPoints& points);

// Returns the file stem of a job's programs and of the files beside them: the part's name; the rest
// of a resumed print gets a suffix.
std::string programsName(const project::Job& job);

// Returns the input of programStage() for a job. All outlive it. Precondition: the job
// has a trajectory.
ProgramStageInput programStageInput(const project::Job& job, const geometry::TriangleMesh& printed,
                                    const platform::PlatformSolid& platform,
                                    const robot::Cell& cell, const Resolved& resolved);

// Returns the head of the program that is written from `said` (see saying()).
program::JobHead headOf(const ProgramStageInput& said);

// Reads `files` as `format` and replays them against the planned motion. `shared`: as for
// programStage().
ReadBack replayText(const std::string& format, const std::vector<plan::ProgramFile>& files,
                    const ProgramStageInput& planned, const base::RunContext& ctx,
                    SharedRuns* shared = nullptr);

// `quality`: by which it was judged.
project::ReplayReport replayReport(const replay::Verification& verdict, const Quality& quality);

// Returns the failed thresholds as text, e.g. "coveredFraction 0.9512 (limit 0.97)".
std::vector<base::Message> failedThresholds(const replay::Verification& verdict);

// Adds a program's row and findings to the report. The first program (the cell's own unless the
// user chose others only) carries the verdict. A program that does not decide, because it is for
// another controller, only adds a finding where it is refused.
void reportProgram(const CheckedProgram& checked, bool first, bool decides, project::Report& report,
                   plan::Findings& findings);

} // namespace voluta::pipeline
