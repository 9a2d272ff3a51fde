#include "pipeline/resume.h"

#include "base/error.h"
#include "base/staged_folder.h"
#include "base/stopwatch.h"
#include "collision/growing_part.h"
#include "motion/check.h"
#include "motion/head_refusals.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "motion/motion_scene.h"
#include "motion/resumed_motion.h"
#include "pipeline/checked_program.h"
#include "pipeline/program_files.h"
#include "pipeline/program_runner.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/stage_record.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "program/dialect.h"
#include "program/program_options.h"
#include "replay/comparison.h"
#include "replay/executed_path.h"
#include "robot/cell.h"

#include <algorithm>
#include <iterator>

namespace voluta::pipeline {

namespace {

using base::Error;
using base::ErrorCode;

// Returns the given program file, or else the first file of the job's first program.
std::filesystem::path fileOfLine(const ResumeRequest& request, const project::Job& job) {
  if (!request.program.empty())
    return request.program;
  const auto& programs = job.report.programs;
  if (programs.empty() || programs.front().files.empty())
    throw Error(ErrorCode::Usage, "the job has no program to take the line from"_text, {},
                "give --program"_text);
  return request.job.parent_path() / programs.front().files.front();
}

// Returns the files with motions, in the order of execution.
std::vector<std::size_t> filesWithMotions(const plan::ReadProgram& read) {
  std::vector<std::size_t> files;
  for (const plan::ProgramMotion& m : read.motions)
    if (std::ranges::find(files, m.file) == files.end())
      files.push_back(m.file);
  return files;
}

// Returns the first motion at or after the requested line. Without a given file it is of the only
// file with motions: in several files the same line means different places of the part.
std::size_t motionAt(const ResumeRequest& request, const FoundProgram& found,
                     const plan::ReadProgram& read) {
  const std::vector<std::size_t> moving = filesWithMotions(read);
  base::Message remedy;
  if (moving.size() > 1)
    remedy = base::message("give --program, a file from {first} to {last}"_text,
                           found.files[moving.front()].name, found.files[moving.back()].name);
  if (request.program.empty() && moving.size() > 1)
    throw Error(ErrorCode::Usage,
                base::message("line {line} is ambiguous: the program has {count} files"_text,
                              *request.line, moving.size()),
                found.files.front().name, std::move(remedy));
  const std::size_t file =
      request.program.empty() && !moving.empty() ? moving.front() : found.named;
  const auto motion = std::ranges::find_if(read.motions, [&](const plan::ProgramMotion& m) {
    return m.file == file && m.line >= *request.line;
  });
  if (motion == read.motions.end())
    throw Error(ErrorCode::Usage,
                base::message("no motion at or after line {line}"_text, *request.line),
                found.files[file].name, std::move(remedy));
  return static_cast<std::size_t>(motion - read.motions.begin());
}

// Returns the point of the job's trajectory from which the motion at the line starts.
std::size_t pointOfLine(const ResumeRequest& request, const PlanResult& planned,
                        const base::RunContext& ctx) {
  const project::Job& job = planned.job;
  const robot::Cell& cell = *planned.cell;
  const FoundProgram found = findProgram(fileOfLine(request, job), job.report.programs);
  const plan::ReadProgram read =
      program::readProgram(std::string(found.dialect->id), found.files, planned.tooling(), ctx);
  std::size_t at = motionAt(request, found, read);
  const plan::Trajectory rest =
      motion::partOf(*job.trajectory, job.resumedAt, job.trajectory->pointCount());
  const program::MergedPoints points =
      program::pointsFor(found.dialect->id,
                         {*job.toolPlan, rest, cell, planned.tooling(), job.item().partName,
                          program::programOptions(planned.resolved().values)},
                         ctx);
  const replay::ExecutedPath path = replay::executeProgram(read, cell, ctx);
  const replay::Alignment alignment =
      replay::alignProgram(read, path, replay::plannedNozzle(*points.trajectory, cell, ctx),
                           *points.trajectory, cell, ctx);
  if (!alignment.deviations.empty() || alignment.gaveUp)
    throw Error(ErrorCode::UnusableInput, "not a program of this job"_text,
                found.files[found.named].name);
  // A piece of a joint motion has no planned point; take the point it leads to.
  while (alignment.pointOf[at] == replay::kUnmatched)
    ++at;
  // If one motion stands in for several points, take the last of them.
  const auto end = std::ranges::upper_bound(points.pointOf, alignment.pointOf[at]);
  const std::size_t point =
      job.resumedAt + static_cast<std::size_t>(end - points.pointOf.begin()) - 1;
  return point == 0 ? 0 : point - 1;
}

// Throws Error{Usage} if the bead at a point was printed before the rest that the job is.
void requireUnprinted(const project::Job& job, std::size_t point) {
  if (job.resumedAt == 0)
    return;
  const std::size_t first = plan::waypointAhead(*job.trajectory, job.resumedAt);
  const std::size_t bead = plan::beadNumber(*job.toolPlan, job.trajectory->waypoint[point]);
  if (first == plan::kNoWaypoint)
    return;
  if (const std::size_t begin = plan::beadNumber(*job.toolPlan, first); bead < begin)
    throw Error(ErrorCode::Usage,
                base::message("bead {bead} is printed: this rest begins with bead {first}"_text,
                              bead, begin),
                {}, "beads have the numbers of the whole print"_text);
}

} // namespace

std::size_t resumePointOf(const ResumeRequest& request, const PlanResult& planned,
                          const base::RunContext& ctx) {
  const project::Job& job = planned.job;
  std::optional<std::size_t> point;
  if (request.bead) {
    if (*request.bead < 1 || *request.bead > job.toolPlan->paths.size())
      throw Error(ErrorCode::Usage, base::message("no bead {bead}: the plan has {beads} beads"_text,
                                                  *request.bead, job.toolPlan->paths.size()));
    point = motion::resumePointOfPath(*job.trajectory, *job.toolPlan, *request.bead - 1);
  } else {
    base::require(request.line.has_value(), "a bead or a line");
    point = motion::resumePoint(*job.trajectory, pointOfLine(request, planned, ctx));
  }
  if (!point)
    throw Error(ErrorCode::UnusableInput, "nothing is printed after that place"_text, {},
                "choose an earlier place"_text);
  requireUnprinted(job, *point);
  return *point;
}

namespace {

void record(PlanResult& result, project::Stage stage, const plan::Findings& findings,
            const project::Timings& timings) {
  recordStage(result.job, stage, project::kResumedKey, findings, timings,
              result.tooling().first().process.beadWidthMaxMm);
}

// Runs the Replay stage of a resumed or a joined job.
void writePrograms(PlanResult& result, const base::RunContext& ctx) {
  const ProgramsOutcome out = runPrograms(result, ProgramHooks(), ctx);
  record(result, project::Stage::Replay, out.findings, out.timings);
}

class Resuming {
public:
  // `planned`: of a job planned up to its motion (resultOf).
  Resuming(PlanResult planned, std::size_t point) : point_(point) {
    result_.plan = std::move(planned);
    const std::size_t waypoint = this->job().trajectory->waypoint[point];
    result_.waypoint = waypoint;
    result_.bead = plan::beadNumber(*this->job().toolPlan, waypoint);
    result_.depositedMm3 = this->job().trajectory->extrudedMm3[point];
    result_.leftMm3 = this->job().trajectory->extrudedMm3.back() - result_.depositedMm3;
  }

  project::Job motionOnly(const base::RunContext& ctx) {
    forgetRest();
    move(ctx);
    return std::move(job());
  }

  ResumeResult run(const base::RunContext& ctx) {
    const base::Stopwatch whole;
    forgetRest();
    if (move(ctx.sub(0.0, 0.2)))
      writePrograms(result_.plan, ctx.sub(0.2, 1.0));
    report().timings.total = whole.seconds();
    report().threads = ctx.threads();
    return std::move(result_);
  }

private:
  project::Job& job() { return result_.plan.job; }
  project::Report& report() { return job().report; }
  motion::MotionOptions motionOptions() {
    return motionOptionsOf(result_.plan.resolved().values, job().choices.seed);
  }

  // The job's motion and program records describe the whole print.
  void forgetRest() {
    const auto trajectory = job().trajectory;
    const std::size_t resumedAt = job().resumedAt;
    const project::MotionReport motion = report().motion;
    // Beads that the whole motion leaves out are missing from its rest, too.
    std::ranges::copy_if(
        report().findings, std::back_inserter(leftOut_), [](const plan::Finding& f) {
          return f.blocking && plan::stageOf(f) == plan::Stage::Motion && !plan::blocksRunning(f);
        });
    job() = project::upTo(job(), project::Stage::Toolpath);
    for (project::ItemReport& item : report().items)
      item.tried.clear();
    job().trajectory = trajectory;
    job().resumedAt = resumedAt;
    report().motion = motion;
  }

  bool move(const base::RunContext& ctx) {
    base::Stopwatch watch;
    ctx.report(0.0, "computing the part printed so far"_text);
    const plan::ToolPlan& plan = *job().toolPlan;
    const process::Tooling& tooling = result_.plan.tooling();
    const double pitch = collision::growingPitch(plan, tooling);
    const collision::GrowingPart growing(
        plan, pitch, ctx, collision::groundCells(project::platformOf(job()), plan, pitch, ctx));
    project::Timings timings;
    timings.collision = watch.seconds();
    watch = base::Stopwatch();
    auto resumed = motion::resumeAt(*job().trajectory, point_, plan, *result_.plan.cell, tooling,
                                    growing, motionOptions(), job().resumedAt, ctx);
    timings.transfer = watch.seconds();
    if (!resumed) {
      const Eigen::Vector3d& where = plan.position[result_.waypoint];
      record(
          result_.plan, project::Stage::Motion,
          {plan::makeFinding(plan::FindingKind::NoPathBack,
                             {{"place", base::message("bead {bead}"_text, result_.bead)}}, where)},
          timings);
      return false;
    }
    const double before = resumed->trajectory.timeS[resumed->firstPoint];
    report().motion.durationS = resumed->trajectory.timeS.back() - before;
    report().motion.waits = 0;
    report().motion.waitS = 0.0;
    report().motion.toolChanges = static_cast<std::size_t>(
        std::ranges::count_if(resumed->trajectory.events, [&](const plan::TrajectoryEvent& event) {
          return event.kind == plan::EventKind::ToolChange && event.point > resumed->firstPoint;
        }));
    for (const plan::TrajectoryEvent& event : resumed->trajectory.events)
      if (event.kind == plan::EventKind::Wait && event.point > resumed->firstPoint) {
        ++report().motion.waits;
        report().motion.waitS += event.seconds;
      }
    for (const plan::TrajectoryEvent& event : resumed->trajectory.events)
      if (event.point > resumed->firstPoint)
        report().motion.durationS += event.seconds;
    job().resumedAt = resumed->firstPoint;
    measure(*resumed, growing, ctx);
    job().trajectory = std::make_shared<plan::Trajectory>(std::move(resumed->trajectory));
    record(result_.plan, project::Stage::Motion, leftOut_, timings);
    return true;
  }

  // Final check of the rest, as done for the whole motion (motion/check.h).
  void measure(const motion::Resumed& resumed, const collision::GrowingPart& growing,
               const base::RunContext& ctx) {
    const motion::MotionOptions options = motionOptions();
    const collision::CellCollision collision(*result_.plan.cell,
                                             result_.plan.tooling().first().process);
    const motion::MotionScene scene{
        *job().toolPlan, *result_.plan.cell,
        collision,       growing,
        options,         motion::leversOf(*job().toolPlan, *result_.plan.cell)};
    const plan::Trajectory rest =
        motion::partOf(resumed.trajectory, resumed.firstPoint, resumed.trajectory.pointCount());
    const motion::TrajectoryCheck check = motion::checkTrajectory(
        rest, scene, motion::headBefore(*job().toolPlan), motion::kClearanceCapMm, ctx);
    report().motion.minClearanceMm = check.minClearanceMm;
    report().motion.minClearanceAtS = rest.timeS[check.closestPoint];
    report().motion.collisions = check.collisions.size();
  }

  std::size_t point_;
  ResumeResult result_;
  plan::Findings leftOut_;
};

// Returns the formats in which a rest is written: those asked for, or that of the program that was
// printed, or those that the job has programs of. Empty: those that the job was planned with.
std::vector<std::string> formatsOf(const ResumeRequest& request, const project::Job& job) {
  const std::vector<project::ProgramReport>& written = job.report.programs;
  if (!request.formats.empty())
    return request.formats;
  if (!request.program.empty())
    return {std::string(findProgram(request.program, written).dialect->id)};
  std::vector<std::string> formats;
  for (const project::ProgramReport& program : written)
    if (!program.files.empty())
      formats.push_back(program.format);
  return formats.size() < written.size() ? formats : std::vector<std::string>();
}

// `formats`: empty: those of the job.
PlanResult resultInFormats(project::Job job, std::vector<std::string> formats) {
  if (!formats.empty())
    job.choices.formats = std::move(formats);
  return resultOf(std::move(job));
}

void requireNoMarks(const plan::Trajectory& trajectory) {
  if (std::ranges::any_of(trajectory.events, [](const plan::TrajectoryEvent& event) {
        return event.kind == plan::EventKind::Mark;
      }))
    throw Error(ErrorCode::UnusableInput, "the job waits for another machine at marks"_text, {},
                "resume the job from which it was made, and print its rest alone"_text);
}
} // namespace

ResumeResult resumeJob(project::Job job, std::size_t point, std::vector<std::string> formats,
                       const base::RunContext& ctx) {
  base::require(job.item().part && job.toolPlan && job.trajectory, "a job with a motion");
  requireNoMarks(*job.trajectory);
  return Resuming(resultInFormats(std::move(job), std::move(formats)), point).run(ctx);
}

project::Job restMotion(PlanResult planned, std::size_t point, const base::RunContext& ctx) {
  return Resuming(std::move(planned), point).motionOnly(ctx);
}

PlanResult written(project::Job job, const base::RunContext& ctx) {
  base::require(job.item().part && job.toolPlan && job.trajectory, "a job with a motion");
  const base::Stopwatch whole;
  PlanResult result = resultOf(project::upTo(std::move(job), project::Stage::Motion));
  writePrograms(result, ctx);
  result.job.report.timings.total = whole.seconds();
  result.job.report.threads = ctx.threads();
  return result;
}

PlanResult writeRest(project::Job job, const base::RunContext& ctx) {
  base::require(job.resumedAt > 0, "a job that is taken up again");
  return written(std::move(job), ctx);
}

ResumeResult resumePrint(const ResumeRequest& request, const base::RunContext& ctx) {
  base::finishStaged(std::filesystem::absolute(request.job).parent_path());
  project::Job job = project::readJob(request.job, allParameters());
  if (!job.item().part || !job.toolPlan || !job.trajectory)
    throw Error(ErrorCode::UnusableInput, "the job has no motion to resume"_text,
                request.job.string(), "plan it without --until"_text);
  std::vector<std::string> formats = formatsOf(request, job);
  PlanResult planned = resultInFormats(std::move(job), std::move(formats));
  const std::size_t point = resumePointOf(request, planned, ctx);
  requireNoMarks(*planned.job.trajectory);
  return Resuming(std::move(planned), point).run(ctx);
}

} // namespace voluta::pipeline
