#include "pipeline/replay_stage.h"

#include "base/error.h"
#include "program/dialect.h"

#include <fmt/format.h>

namespace voluta::pipeline {

replay::Verification replayText(const std::string& format,
                                const std::vector<plan::ProgramFile>& files, const Job& job,
                                const robot::Cell& cell, const process::Process& process,
                                const base::RunContext& ctx) {
  base::require(job.part && job.toolPlan && job.trajectory, "replayText: the job is planned");
  ctx.report(0.0, "replay " + format);
  const plan::ReadProgram read = program::readProgram(format, files, process, ctx.sub(0.0, 0.1));
  return replay::replayProgram({read, *job.toolPlan, *job.trajectory, cell, process, *job.part}, {},
                               ctx.sub(0.1, 1.0));
}

ReplayReport replayReport(const replay::Verification& verdict) {
  ReplayReport r;
  r.passed = verdict.passed;
  r.coveredFraction = verdict.coveredFraction;
  r.unsupportedFraction = verdict.unsupportedFraction;
  r.overfillFraction = verdict.overfillFraction;
  r.massRatio = verdict.massRatio;
  r.collisions = verdict.collisions;
  r.limitViolations = verdict.limitViolations;
  r.maxDeviationMm = verdict.maxDeviationMm;
  const replay::ReplayThresholds limits;
  r.thresholds.covered = limits.coveredMin;
  r.thresholds.unsupported = limits.unsupportedMax;
  r.thresholds.overfill = limits.overfillMax;
  r.thresholds.mass = limits.massTolerance;
  r.thresholds.collisions = limits.collisionsMax;
  r.thresholds.limitViolations = limits.limitViolationsMax;
  r.thresholds.deviationMm = limits.deviationMaxMm;
  return r;
}

std::string failedThresholds(const replay::Verification& verdict) {
  std::string text;
  for (const replay::ThresholdResult& result : verdict.results)
    if (!result.passed)
      text += fmt::format("{}{} {:.4g} (limit {:.4g})", text.empty() ? "" : ", ", result.name,
                          result.value, result.limit);
  if (verdict.deviations > 0)
    text += fmt::format("{}{} places where the text is not what was planned",
                        text.empty() ? "" : ", ", verdict.deviations);
  return text.empty() ? "passed" : text;
}

} // namespace voluta::pipeline
