// The rest of a print that was stopped: from a bead or a line of its program on.
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
  std::filesystem::path job; // planned to its motion
  // One of them. A bead is a path of the plan, from 1, begun anew. A line, from 1, is of a motion
  // of `program`: what it moves away from is where the print goes on; of a line that lays nothing
  // the next that does.
  std::optional<std::size_t> bead, line;
  // The file that the line is of, of any program of the job. Empty: of the first program, beside
  // the job, the only file that has motions.
  std::filesystem::path program;
  std::vector<std::string> formats; // empty: the job's
};

struct ResumeResult {
  PlanResult plan;          // of the rest: its programs, and the motion with what came before
  std::size_t bead = 0;     // from 1
  std::size_t waypoint = 0; // at which it begins
  double laidMm3 = 0.0, leftMm3 = 0.0;
};

// The part stands as it is when that place is come to. From home the arm approaches clear of it
// (motion/resume.h), and the rest is as it was planned. Its programs are written, read back and
// replayed behind what was printed before, so that the verdict is on the whole part. Where no way
// leads there, that is a finding, and there are no programs.
// Throws Error{UnreadableFile}: the job, the program. Throws Error{UnusableInput}: no motion in the
// job, not its program, nothing left to print. Throws Error{Usage}: no such bead or line, a line
// that may be of several files, a format that is not known; Cancelled.
ResumeResult resumePrint(const ResumeRequest& request, const base::RunContext& ctx);
// The same for a job at hand, from a point of its trajectory (motion::resumePoint).
ResumeResult resumeJob(project::Job job, std::size_t point, std::vector<std::string> formats,
                       const base::RunContext& ctx);

// The programs of a job that is taken up again (resumedAt > 0) written anew, as its choices have
// them now; its motion stays. Precondition (Error{Internal}): it is planned to its motion.
PlanResult writeRest(project::Job job, const base::RunContext& ctx);

} // namespace voluta::pipeline
