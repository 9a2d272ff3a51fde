#include "base/error.h"
#include "base/files.h"
#include "pipeline/choices.h"
#include "pipeline/program_files.h"
#include "pipeline/replay_stage.h"
#include "pipeline/road.h"
#include "program/dialect.h"
#include "robot/cell.h"

#include <utility>

namespace voluta::pipeline {

VerifyResult verifyProgram(const std::filesystem::path& program, const std::filesystem::path& job,
                           const base::RunContext& ctx) {
  std::string text = base::readFile(program);
  const project::Job planned = project::readJob(job);
  if (!planned.part || !planned.toolPlan || !planned.trajectory)
    throw base::Error(base::ErrorCode::UnusableInput,
                      "the job holds no motion to verify against"_text, job.string(),
                      "plan it without --until"_text);
  const FoundProgram found = findProgram(program, std::move(text));
  const std::string format(found.dialect->id);
  const process::Process process = chosenProcess(planned.choices, parameterValues(planned.choices));
  const robot::Cell cell = robot::loadCell(planned.choices.cell, process, planned.platform);
  const ProgramStageInput in{planned.printed(),
                             planned.platform,
                             *planned.toolPlan,
                             *planned.trajectory,
                             cell,
                             process,
                             planned.partName,
                             {},
                             planned.resumedAt};
  const program::MergedPoints points =
      program::pointsFor(format, {in.toolPlan, in.trajectory, in.cell, in.process, in.name}, ctx);
  const replay::Verification verdict =
      replayText(format, found.files, saying(in, points), ctx).verdict;
  return {format, replayReport(verdict), verdict.findings};
}

} // namespace voluta::pipeline
