#include "base/error.h"
#include "base/staged_folder.h"
#include "pipeline/judged_part.h"
#include "pipeline/program_files.h"
#include "pipeline/replay_stage.h"
#include "pipeline/resolved.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/job_head.h"
#include "robot/cell.h"

#include <optional>
#include <utility>

namespace voluta::pipeline {

namespace {
base::Message inWords(const program::JobHead& head) {
  return base::message("part {part}, job {job}, cell {cell} with robot {robot}"_text, head.part,
                       head.job, head.cell, head.robot);
}

// Returns a finding if the program's head names another job; nullopt if it names this job or none.
std::optional<plan::Finding> otherOrigin(const std::vector<plan::ProgramFile>& files,
                                         const program::JobHead& own) {
  const std::optional<program::JobHead> head = program::readJobHead(files);
  if (!head || head->job == own.job)
    return std::nullopt;
  const bool cell = !head->cell.empty() && head->cell != own.cell;
  return plan::makeFinding(cell ? plan::FindingKind::OtherCell : plan::FindingKind::OtherJob,
                           {{"program", inWords(*head)}, {"job", inWords(own)}});
}

// Binary files and texts in an unknown language contain nothing to judge.
void requireMotions(const ReadBack& back, const std::string& format,
                    const std::filesystem::path& program) {
  const auto& defects = back.defects;
  if (back.verdict.motionPlaces.size() > back.firstMotion || defects.empty())
    return;
  throw base::Error(base::ErrorCode::UnusableInput,
                    base::message("no {format} motion found: line {line}: {what}"_text, format,
                                  defects.front().line, defects.front().reason),
                    program.string());
}
} // namespace

VerifyResult verifyProgram(const std::filesystem::path& program, const std::filesystem::path& job,
                           const base::RunContext& ctx) {
  base::finishStaged(std::filesystem::absolute(job).parent_path());
  const project::Job planned = project::readJob(job, allParameters());
  if (!planned.item().part || !planned.toolPlan || !planned.trajectory)
    throw base::Error(base::ErrorCode::UnusableInput,
                      "the job has no motion to verify against"_text, job.string(),
                      "plan it without --until"_text);
  return verifyProgram(program, planned, ctx);
}

VerifyResult verifyProgram(const std::filesystem::path& program, const project::Job& planned,
                           const base::RunContext& ctx) {
  base::require(planned.item().part && planned.toolPlan && planned.trajectory,
                "verifyProgram: a job with its motion");
  base::finishStaged(std::filesystem::absolute(program).parent_path());
  const FoundProgram found = findProgram(program, planned.report.programs);
  const std::string format(found.dialect->id);
  const Resolved resolved = resolve(planned.choices);
  const platform::PlatformSolid platform = project::platformOf(planned);
  const robot::Cell cell =
      robot::loadCell(planned.choices.cell, resolved.tooling.first().process, platform);
  const auto printed = judgedPart(planned, resolved);
  const ProgramStageInput in = programStageInput(planned, *printed, platform, cell, resolved);
  const program::MergedPoints points = program::pointsFor(
      format, {in.toolPlan, in.trajectory, in.cell, in.tooling, in.name, in.options}, ctx);
  const ProgramStageInput said = saying(in, points);
  ReadBack back = replayText(format, found.files, said, ctx);
  requireMotions(back, format, program);
  replay::Verification& verdict = back.verdict;
  if (std::optional<plan::Finding> other = otherOrigin(found.files, headOf(said))) {
    // If the motions are this job's anyway, a foreign head is only worth mentioning.
    other->blocking = !verdict.safeToRun;
    verdict.findings.insert(verdict.findings.begin(), std::move(*other));
  }
  // What the plan leaves out, no replay of its program can find.
  for (const plan::Finding& finding : planned.report.findings)
    if (finding.blocking && plan::stageOf(finding) != plan::Stage::Replay)
      verdict.findings.push_back(finding);
  return {format, replayReport(verdict, in.quality), verdict.findings};
}

} // namespace voluta::pipeline
