// Resumes a stopped print from a bead or from a line of its program.
#pragma once

#include "base/run_context.h"
#include "pipeline/road.h"
#include "project/job.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace voluta::pipeline {

struct ResumeRequest {
  std::filesystem::path job; // a job planned up to its motion
  // Exactly one of them is set. `bead`: a path of the plan, 1-based, printed again from its start.
  // `line`: 1-based; of a motion of `program`. The print resumes at that motion's start point; if
  // the motion deposits nothing, at the next one that does.
  std::optional<std::size_t> bead, line;
  // The file that `line` refers to, of any program of the job. Empty: the only file with motions of
  // the job's first program, beside the job.
  std::filesystem::path program;
  // Empty: that of `program`, if it is given, or else those that the job has programs of.
  std::vector<std::string> formats;
};

struct ResumeResult {
  PlanResult plan;      // the rest: its programs, and the motion including the part printed before
  std::size_t bead = 0; // 1-based
  std::size_t waypoint = 0; // at which the rest begins
  double depositedMm3 = 0.0, leftMm3 = 0.0;
};

// Plans and writes the rest of a print, with the part as printed so far. The arm approaches from
// home clear of that part (motion/resumed_motion.h); after that the rest is as planned before. Its
// programs are written, read back and replayed after the motions printed before, so that the
// verdict covers the whole part. If no collision-free way leads to the place, the result has a
// finding and no programs. Throws Error{UnreadableFile} for the job or the program;
// Error{UnusableInput} if the job has no motion or has marks for another machine, the program is
// not the job's or nothing is left to print; Error{Usage} if there is no such bead or line, the
// line may be of several files or a format is unknown; Cancelled.
ResumeResult resumePrint(const ResumeRequest& request, const base::RunContext& ctx);
// Same for a job in memory, from a point of its trajectory (motion::resumePoint).
ResumeResult resumeJob(project::Job job, std::size_t point, std::vector<std::string> formats,
                       const base::RunContext& ctx);

// Returns the point of a planned job's trajectory at which its print resumes. Throws as
// resumePrint().
std::size_t resumePointOf(const ResumeRequest& request, const PlanResult& planned,
                          const base::RunContext& ctx);
// Returns the job with the motion of its rest from that point on, without programs. If no way leads
// there, its report has a finding and resumedAt is 0. Precondition: as resumeJob(), without marks.
project::Job restMotion(PlanResult planned, std::size_t point, const base::RunContext& ctx);

// Writes the programs of a job again with its motion as it is, say with marks in it. Precondition
// (Error{Internal}): the job is planned up to its motion.
PlanResult written(project::Job job, const base::RunContext& ctx);
// Writes the programs of a resumed job (resumedAt > 0) again with its present choices; the motion
// stays. Precondition (Error{Internal}): the job is planned up to its motion.
PlanResult writeRest(project::Job job, const base::RunContext& ctx);

} // namespace voluta::pipeline
