#include "base/error.h"
#include "base/files.h"
#include "pipeline/choices.h"
#include "pipeline/replay_stage.h"
#include "pipeline/road.h"
#include "program/dialect.h"
#include "robot/cell.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {
// `program` and the files beside it that it goes on in, each once.
std::vector<plan::ProgramFile> filesOf(const std::filesystem::path& program,
                                       const program::Dialect& dialect, std::string text) {
  std::vector<plan::ProgramFile> files{{program.filename().string(), std::move(text)}};
  if (!dialect.goesOnIn)
    return files;
  for (std::size_t i = 0; i < files.size(); ++i)
    for (const std::string& name : dialect.goesOnIn(files[i].text)) {
      const bool known = std::any_of(files.begin(), files.end(),
                                     [&](const plan::ProgramFile& f) { return f.name == name; });
      if (!known && !name.empty() && name == std::filesystem::path(name).filename())
        files.push_back({name, base::readFile(program.parent_path() / name)});
    }
  return files;
}
} // namespace

VerifyResult verifyProgram(const std::filesystem::path& program, const std::filesystem::path& job,
                           const base::RunContext& ctx) {
  std::string text = base::readFile(program);
  const project::Job planned = project::readJob(job);
  if (!planned.part || !planned.toolPlan || !planned.trajectory)
    throw base::Error(base::ErrorCode::UnusableInput,
                      "the job holds no motion to verify against"_text, job.string(),
                      "plan it without --until"_text);
  const program::Dialect* dialect = program::detectDialect(program.filename().string(), text);
  if (!dialect)
    throw base::Error(base::ErrorCode::UnusableInput, "not a program in any known format"_text,
                      program.string(), "see: list formats"_text);
  const std::vector<plan::ProgramFile> files = filesOf(program, *dialect, std::move(text));
  const process::Process process = chosenProcess(planned.choices, parameterValues(planned.choices));
  const robot::Cell cell = robot::loadCell(planned.choices.cell, process, planned.platform);
  const ProgramStageInput in{
      planned.printed(), planned.platform, *planned.toolPlan, *planned.trajectory, cell,
      process,           planned.partName};
  const program::MergedPoints points = program::pointsFor(
      dialect->id, {in.toolPlan, in.trajectory, in.cell, in.process, in.name}, ctx);
  const replay::Verification verdict =
      replayText(std::string(dialect->id), files, saying(in, points.trajectory), ctx).verdict;
  return {std::string(dialect->id), replayReport(verdict), verdict.findings};
}

} // namespace voluta::pipeline
