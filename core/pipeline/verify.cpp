#include "base/error.h"
#include "base/files.h"
#include "pipeline/choices.h"
#include "pipeline/replay_stage.h"
#include "pipeline/road.h"
#include "program/dialect.h"
#include "robot/cell.h"

namespace voluta::pipeline {

VerifyResult verifyProgram(const std::filesystem::path& program, const std::filesystem::path& job,
                           const base::RunContext& ctx) {
  const std::vector<plan::ProgramFile> files{
      {program.filename().string(), base::readFile(program)}};
  const Job planned = readJob(job);
  if (!planned.part || !planned.toolPlan || !planned.trajectory)
    throw base::Error(base::ErrorCode::UnusableInput, "the job holds no motion to verify against",
                      job.string(), "plan it without --until");
  const program::Dialect* dialect = program::detectDialect(files[0].name, files[0].text);
  if (!dialect)
    throw base::Error(base::ErrorCode::UnusableInput, "not a program in any known format",
                      program.string(), "see: list formats");
  const process::Process process = chosenProcess(planned.choices, parameterValues(planned.choices));
  const robot::Cell cell = robot::loadCell(planned.choices.cell, process, planned.platform);
  const ProgramStageInput in{*planned.part, *planned.toolPlan, *planned.trajectory,
                             cell,          process,           planned.partName};
  const replay::Verification verdict = replayText(std::string(dialect->id), files, in, ctx).verdict;
  return {std::string(dialect->id), replayReport(verdict), verdict.findings};
}

} // namespace voluta::pipeline
