#include "pipeline/replay_stage.h"

#include "base/stopwatch.h"
#include "program/dialect.h"

namespace voluta::pipeline {

namespace {
TextLine textLine(std::size_t file, std::size_t line) {
  return {static_cast<std::uint32_t>(file), static_cast<std::uint32_t>(line)};
}
program::ProgramInput programInput(const ProgramStageInput& in) {
  return {in.toolPlan, in.trajectory, in.cell, in.process, in.name, in.options};
}
} // namespace

ProgramStageInput saying(const ProgramStageInput& in, const plan::Trajectory& points) {
  return {in.part, in.platform, in.toolPlan, points, in.cell, in.process, in.name, in.options};
}

ReadBack replayText(const std::string& format, const std::vector<plan::ProgramFile>& files,
                    const ProgramStageInput& in, const base::RunContext& ctx,
                    replay::JudgedRuns* judged) {
  ctx.report(0.0, base::message("replay {format}"_text, format));
  ReadBack back;
  back.read = program::readProgram(format, files, in.process, ctx.sub(0.0, 0.1));
  back.verdict = replay::replayProgram(
      {back.read, in.toolPlan, in.trajectory, in.cell, in.process, in.part, in.platform}, {},
      ctx.sub(0.1, 1.0), judged);
  return back;
}

project::ReplayReport replayReport(const replay::Verification& verdict) {
  project::ReplayReport r;
  r.passed = verdict.passed;
  r.coveredFraction = verdict.coveredFraction;
  r.unsupportedFraction = verdict.unsupportedFraction;
  r.halfCarriedFraction = verdict.halfCarriedFraction;
  r.longestUnsupportedMm = verdict.longestUnsupportedMm;
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

std::vector<base::Message> failedThresholds(const replay::Verification& verdict) {
  std::vector<base::Message> failed;
  for (const replay::ThresholdResult& result : verdict.results)
    if (!result.passed)
      failed.push_back(base::message("{threshold} {value:.4g} (limit {limit:.4g})"_text,
                                     result.name, base::number(result.value),
                                     base::number(result.limit)));
  if (verdict.deviations > 0)
    failed.push_back(base::message("{places} place where the text is not what was planned|"
                                   "{places} places where the text is not what was planned"_plural,
                                   verdict.deviations));
  return failed;
}

std::shared_ptr<const CheckedProgram> programStage(const std::string& format,
                                                   const ProgramStageInput& in,
                                                   const base::RunContext& ctx,
                                                   replay::JudgedRuns* judged) {
  auto checked = std::make_shared<CheckedProgram>();
  base::Stopwatch writing;
  ctx.report(0.0, base::message("write {format}"_text, format));
  const program::MergedPoints points =
      program::pointsFor(format, programInput(in), ctx.sub(0.0, 0.05));
  const ProgramStageInput said = saying(in, points.trajectory);
  checked->program = program::writeProgram(format, programInput(said), ctx.sub(0.05, 0.1));
  checked->timings.write = writing.seconds();
  base::Stopwatch replaying;
  ReadBack back = replayText(format, checked->program.files, said, ctx.sub(0.1, 1.0), judged);
  checked->timings.replay = replaying.seconds();
  checked->motionLines.reserve(points.pointOf.size());
  for (const std::size_t point : points.pointOf)
    if (point < back.read.motions.size())
      checked->motionLines.push_back(
          textLine(back.read.motions[point].file, back.read.motions[point].line));
  replay::Verification& verdict = back.verdict;
  checked->verdict = replayReport(verdict);
  checked->passed = verdict.passed;
  checked->failed = failedThresholds(verdict);
  // Of a text that is not what was planned, its motions are not the plan's.
  if (verdict.deviations == 0)
    checked->metAt = std::move(verdict.metAt);
  checked->maxDeviationMm = verdict.maxDeviationMm;
  checked->maxDeviationRad = verdict.maxDeviationRad;
  // Lines are of this program's text, and there are several programs.
  for (plan::Finding& finding : verdict.findings)
    finding.program.format = format;
  checked->findings = std::move(verdict.findings);
  for (const replay::TextPlace& place : verdict.places)
    checked->findingLines.push_back(textLine(place.file, place.line));
  return checked;
}

std::vector<TextLine> linesOfPoints(const CheckedProgram& program,
                                    const plan::Trajectory& trajectory) {
  std::vector<TextLine> lines = program.motionLines;
  lines.resize(trajectory.pointCount());
  return lines;
}

} // namespace voluta::pipeline
