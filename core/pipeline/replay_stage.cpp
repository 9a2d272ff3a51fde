#include "pipeline/replay_stage.h"

#include "base/shown_number.h"
#include "base/stopwatch.h"
#include "motion/motion_options.h"
#include "motion/resumed_motion.h"
#include "pipeline/checked_program.h"
#include "pipeline/head_verdict.h"
#include "pipeline/replayed/shared_runs.h"
#include "pipeline/resolved.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/read_hash.h"
#include "project/job.h"
#include "project/part_formats.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <numeric>

namespace voluta::pipeline {

namespace {
TextLine textLine(std::size_t file, std::size_t line) {
  return {static_cast<std::uint32_t>(file), static_cast<std::uint32_t>(line)};
}

program::ProgramInput programInput(const ProgramStageInput& in,
                                   const plan::Trajectory& trajectory) {
  program::ProgramInput input{in.toolPlan, trajectory, in.cell, in.tooling,
                              in.name,     in.options, in.job,  in.arcs};
  input.verdict = kPassedVerdict;
  return input;
}

// Returns the arcs of the points [first, last), numbered from `first`. The arc to `first` is none.
std::vector<program::ArcVia> arcsBetween(std::span<const program::ArcVia> arcs, std::size_t first,
                                         std::size_t last) {
  std::vector<program::ArcVia> part;
  for (program::ArcVia arc : arcs)
    if (arc.point > first && arc.point < last) {
      arc.point -= first;
      part.push_back(arc);
    }
  return part;
}

// Returns the motions printed before the program begins, in its dialect and with line 0.
std::vector<plan::ProgramMotion>
motionsBefore(const std::string& format, const ProgramStageInput& in, const base::RunContext& ctx) {
  const plan::Trajectory before = motion::partOf(in.trajectory, 0, in.firstPoint);
  const std::vector<program::ArcVia> arcs = arcsBetween(in.arcs, 0, in.firstPoint);
  program::ProgramInput input = programInput(in, before);
  input.arcs = arcs;
  const plan::Program program = program::writeProgram(format, input, ctx);
  plan::ReadProgram read = program::readProgram(format, program.files, in.tooling, ctx);
  for (plan::ProgramMotion& motion : read.motions)
    motion.file = motion.line = 0;
  return std::move(read.motions);
}

// Calls `use` with the input a program is written from.
template <typename F> auto withInput(const ProgramStageInput& in, const F& use) {
  if (in.firstPoint == 0)
    return use(programInput(in, in.trajectory));
  const plan::Trajectory rest =
      motion::partOf(in.trajectory, in.firstPoint, in.trajectory.pointCount());
  const std::vector<program::ArcVia> arcs =
      arcsBetween(in.arcs, in.firstPoint, in.trajectory.pointCount());
  program::ProgramInput input = programInput(in, rest);
  input.arcs = arcs;
  return use(input);
}
} // namespace

ProgramStageInput saying(const ProgramStageInput& in, const program::MergedPoints& points) {
  const std::size_t first = in.firstPoint > 0 ? points.pointOf[in.firstPoint] : 0;
  // A merged point stands in for the omitted points before it and ends where the last of them ends.
  std::vector<std::size_t> commonPoint(points.trajectory->pointCount(), 0);
  for (std::size_t point = 0; point < points.pointOf.size(); ++point)
    commonPoint[points.pointOf[point]] = point;
  return {in.part,
          in.platform,
          in.toolPlan,
          *points.trajectory,
          in.cell,
          in.tooling,
          in.name,
          in.options,
          first,
          withInput(in, [](const program::ProgramInput& all) { return program::jobHash(all); }),
          std::move(commonPoint),
          in.firstTriangle,
          points.arcs,
          {&in.trajectory, points.pointOf},
          in.layerTimes,
          in.quality,
          in.blockers};
}

std::string programsName(const project::Job& job) {
  const std::string more =
      job.items.size() > 1 ? "-and-" + std::to_string(job.items.size() - 1) + "-more" : "";
  const std::string& part = job.item().partName;
  // Programs must not replace the G-code that they were made from.
  return std::string(project::isSlicedFile(part) ? "robot_" : "") +
         std::filesystem::path(part).stem().string() + more + (job.resumedAt > 0 ? "-rest" : "");
}

ProgramStageInput programStageInput(const project::Job& job, const geometry::TriangleMesh& printed,
                                    const platform::PlatformSolid& platform,
                                    const robot::Cell& cell, const Resolved& resolved) {
  ProgramStageInput in{printed, platform,         *job.toolPlan,    *job.trajectory,
                       cell,    resolved.tooling, programsName(job)};
  in.options = program::programOptions(resolved.values);
  in.firstPoint = job.resumedAt;
  in.firstTriangle = project::firstTriangles(job);
  in.layerTimes = motion::layerTimes(resolved.values);
  in.quality = qualityOf(resolved.values);
  std::ranges::copy_if(job.report.findings, std::back_inserter(in.blockers),
                       [](const plan::Finding& finding) {
                         return finding.blocking && plan::stageOf(finding) != plan::Stage::Replay;
                       });
  return in;
}

program::JobHead headOf(const ProgramStageInput& said) {
  return withInput(said, [](const program::ProgramInput& in) { return program::jobHead(in); });
}

ReadBack replayText(const std::string& format, const std::vector<plan::ProgramFile>& files,
                    const ProgramStageInput& in, const base::RunContext& ctx, SharedRuns* shared) {
  ctx.report(0.0, base::message("replaying {format}"_text, format));
  plan::ReadProgram read = program::readProgram(format, files, in.tooling, ctx.sub(0.0, 0.1));
  const std::uint64_t hash = program::readHash(read);
  if (in.firstPoint > 0) {
    std::vector<plan::ProgramMotion> motions = motionsBefore(format, in, ctx);
    read.firstMotion = motions.size();
    for (plan::ProgramPause& pause : read.pauses)
      pause.before += read.firstMotion;
    for (plan::StatedFact& fact : read.facts)
      fact.before += read.firstMotion;
    for (plan::StatedPosture& stated : read.postures)
      stated.motion += read.firstMotion;
    motions.insert(motions.end(), read.motions.begin(), read.motions.end());
    read.motions = std::move(motions);
  }
  ReadBack back{read.firstMotion, read.defects, hash, {}};
  replay::ReplayInput input{std::move(read), in.toolPlan,      in.trajectory, in.cell,
                            in.tooling,      in.part,          in.platform,   in.firstPoint,
                            in.commonPoint,  in.firstTriangle, in.whole,      in.layerTimes};
  const base::RunContext rest = ctx.sub(0.1, 1.0);
  const replay::ReplayThresholds limits = thresholdsOf(in.quality);
  back.verdict = shared ? replayShared(std::move(input), limits, *shared, rest)
                        : replay::replayProgram(std::move(input), limits, rest);
  // Exclude the time of the motions printed before this program.
  const auto& seconds = back.verdict.motionS;
  back.verdict.durationS -= std::accumulate(
      seconds.begin(), seconds.begin() + static_cast<std::ptrdiff_t>(back.firstMotion), 0.0);
  return back;
}

project::ReplayReport replayReport(const replay::Verification& verdict, const Quality& quality) {
  project::ReplayReport r;
  r.passed = verdict.passed;
  r.safeToRun = verdict.safeToRun;
  r.coveredFraction = verdict.coveredFraction;
  r.thinFraction = verdict.thinFraction;
  r.thinMm3 = verdict.thinMm3;
  r.unsupportedFraction = verdict.unsupportedFraction;
  r.halfCarriedFraction = verdict.halfCarriedFraction;
  r.longestUnsupportedMm = verdict.longestUnsupportedMm;
  r.overfillFraction = verdict.overfillFraction;
  r.massRatio = verdict.massRatio;
  r.collisions = verdict.collisions;
  r.limitViolations = verdict.limitViolations;
  r.maxDeviationMm = verdict.maxDeviationMm;
  r.controllerDurationS = verdict.durationS;
  r.flowErrorFraction = verdict.flowErrorFraction;
  for (const replay::ItemFigures& item : verdict.items)
    r.items.push_back(
        {item.coveredFraction, item.unsupportedFraction, item.massRatio, item.thinFraction});
  r.shortestLayerTimeS = verdict.layerTimes.shortestS;
  r.meanLayerTimeS = verdict.layerTimes.meanS;
  r.longestLayerTimeS = verdict.layerTimes.longestS;
  r.layerTimesMm = verdict.layerTimes.lengthMm;
  r.tapeMm3 = verdict.tapeMm3;
  const replay::ReplayThresholds limits = thresholdsOf(quality);
  r.thresholds.quality = quality.level;
  r.thresholds.accepted = textOf(beyondLevel(quality));
  r.thresholds.covered = limits.coveredMin;
  r.thresholds.unsupported = limits.unsupportedMax;
  r.thresholds.overfill = limits.overfillMax;
  r.thresholds.mass = limits.massTolerance;
  r.thresholds.thin = limits.thinMax;
  r.thresholds.collisions = limits.collisionsMax;
  r.thresholds.limitViolations = limits.limitViolationsMax;
  r.thresholds.deviationMm = limits.deviationMaxMm;
  r.thresholds.flowError = limits.flowErrorMax;
  return r;
}

namespace {
// Returns the value with four significant digits. The mass ratio is held to its distance from 1.
double shownValue(const replay::ThresholdResult& result) {
  constexpr int kDigits = 4;
  const bool isRatio = result.name == "massRatio";
  const double limit = !isRatio             ? result.limit
                       : result.value < 1.0 ? 1.0 - result.limit
                                            : 1.0 + result.limit;
  const double size = std::abs(result.value);
  const int before = size >= 1.0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 0;
  return base::roundedBeyond(result.value, limit, std::max(0, kDigits - before));
}
} // namespace

std::vector<base::Message> failedThresholds(const replay::Verification& verdict) {
  std::vector<base::Message> failed;
  for (const replay::ThresholdResult& result : verdict.results)
    if (!result.passed)
      failed.push_back(base::message("{threshold} {value:.4g} (limit {limit:.4g})"_text,
                                     result.name, base::number(shownValue(result)),
                                     base::number(result.limit)));
  if (verdict.deviations > 0)
    failed.push_back(base::message("{places} place where the program differs from the plan|"
                                   "{places} places where the program differs from the plan"_plural,
                                   verdict.deviations));
  return failed;
}

namespace {
// A program without a text, with the reason why there is none.
std::shared_ptr<const CheckedProgram> refusedProgram(const program::Dialect& dialect,
                                                     const ProgramStageInput& in,
                                                     const base::Error& reason) {
  auto checked = std::make_shared<CheckedProgram>();
  checked->program.format = dialect.id;
  checked->program.foreign = program::isForeign(dialect, in.cell);
  checked->verdict = replayReport({}, in.quality);
  checked->failed = {reason.whole()};
  checked->refusal = base::Error(reason.code(), reason.message(), reason.context()).whole();
  checked->refusalHelp = reason.remedy().empty()
                             ? base::Message("choose another program format"_text)
                             : reason.remedy();
  return checked;
}
} // namespace

namespace {
// Writes the verdict into the heads, unless it is the one that they were written with. Only
// comments change, which is checked: the text that is released is read as the replayed one was.
void putVerdict(CheckedProgram& checked, const program::Dialect& dialect, const ReadBack& back,
                const ProgramStageInput& in, const base::RunContext& ctx) {
  const std::string verdict =
      headVerdict(back.verdict, in.blockers, textOf(beyondLevel(in.quality)));
  std::vector<plan::ProgramFile>& files = checked.program.files;
  if (verdict == kPassedVerdict || !program::replaceVerdict(files, verdict, dialect.longestLine))
    return;
  const plan::ReadProgram read =
      program::readProgram(std::string(dialect.id), files, in.tooling, ctx.quiet());
  base::require(program::readHash(read) == back.hash, "a verdict that changes a comment only");
}
} // namespace

std::shared_ptr<const CheckedProgram> programStage(const std::string& format,
                                                   const ProgramStageInput& in,
                                                   const base::RunContext& ctx,
                                                   SharedRuns* shared) {
  const program::Dialect& dialect = program::findDialect(format);
  // A format that cannot move the cell at all is an invalid request, not a property of the plan.
  program::requireOwnRobot(dialect, in.cell);
  program::requireRodTurns(dialect, in.cell);
  const auto refused = withInput(in, [&](const program::ProgramInput& input) {
    return program::refusal(dialect, in.cell, {}, &input.trajectory);
  });
  if (refused)
    return refusedProgram(dialect, in, *refused);
  auto checked = std::make_shared<CheckedProgram>();
  base::Stopwatch writing;
  ctx.report(0.0, base::message("writing {format}"_text, format));
  const program::MergedPoints points =
      program::pointsFor(format, programInput(in, in.trajectory), ctx.sub(0.0, 0.05));
  const ProgramStageInput said = saying(in, points);
  checked->program = withInput(said, [&](const program::ProgramInput& input) {
    return program::writeProgram(format, input, ctx.sub(0.05, 0.1));
  });
  checked->timings.write = writing.seconds();
  base::Stopwatch replaying;
  ReadBack back = replayText(format, checked->program.files, said, ctx.sub(0.1, 1.0), shared);
  replay::Verification& verdict = back.verdict;
  putVerdict(*checked, dialect, back, said, ctx);
  checked->timings.replay = replaying.seconds();
  checked->pointLines.resize(in.trajectory.pointCount());
  std::vector<TextLine> lines(said.trajectory.pointCount());
  for (std::size_t m = 0; m < verdict.motionPlaces.size(); ++m)
    if (const std::size_t point = verdict.pointOf[m]; point < lines.size())
      lines[point] = textLine(verdict.motionPlaces[m].file - 1, verdict.motionPlaces[m].line);
  for (std::size_t i = 0; i < checked->pointLines.size(); ++i)
    checked->pointLines[i] = lines[points.pointOf[i]];
  checked->verdict = replayReport(verdict, in.quality);
  checked->worst = verdict.worst;
  checked->deviations = verdict.deviations;
  checked->armChecked = verdict.armChecked;
  checked->safeToRun = verdict.safeToRun;
  checked->failed = failedThresholds(verdict);
  checked->slow = slowSpans(said.trajectory, verdict.pointOf, verdict.motionS);
  // With deviations, the text's motions do not correspond to the plan's waypoints.
  if (verdict.deviations == 0)
    checked->collidingWaypoints = std::move(verdict.collidingWaypoints);
  checked->maxDeviationMm = verdict.maxDeviationMm;
  checked->maxDeviationRad = verdict.maxDeviationRad;
  // Line numbers refer to this program's text, and a job may have several programs.
  for (plan::Finding& finding : verdict.findings)
    finding.program.format = format;
  checked->findings = std::move(verdict.findings);
  for (const replay::TextPlace& place : verdict.places)
    checked->findingLines.push_back(textLine(place.file, place.line));
  return checked;
}

namespace {
plan::Finding refusalOf(const CheckedProgram& checked) {
  using enum plan::FindingKind;
  if (checked.refusal)
    return plan::makeFinding(FormatRefused, {{"format", checked.program.format},
                                             {"why", *checked.refusal},
                                             {"help", *checked.refusalHelp}});
  // The remedy of ProgramRefused is to see these.
  if (std::ranges::any_of(checked.findings, &plan::Finding::blocking))
    return plan::makeFinding(ProgramRefused,
                             {{"format", checked.program.format}, {"failed", checked.failed}});
  return plan::makeFinding(
      FormatRefused,
      {{"format", checked.program.format},
       {"why", checked.failed},
       {"help",
        base::Message(
            "change parameters, process or cell of the plan, or leave this format out"_text)}});
}
} // namespace

void reportProgram(const CheckedProgram& checked, bool first, bool decides, project::Report& report,
                   plan::Findings& findings) {
  project::ProgramReport row;
  row.format = checked.program.format;
  row.foreign = checked.program.foreign;
  for (const plan::ProgramFile& file : checked.program.files) {
    row.files.push_back(file.name);
    row.bytes += file.text.size();
  }
  row.maxDeviationMm = checked.maxDeviationMm;
  row.maxDeviationRad = checked.maxDeviationRad;
  row.durationS = checked.verdict.controllerDurationS;
  row.flowErrorFraction = checked.verdict.flowErrorFraction;
  row.massRatio = checked.verdict.massRatio;
  report.programs.push_back(std::move(row));
  if (first)
    report.replay = checked.verdict;
  if (!checked.safeToRun && !decides) {
    findings.push_back(
        plan::makeFinding(plan::FindingKind::ForeignRefused,
                          {{"format", checked.program.format}, {"failed", checked.failed}}));
    return;
  }
  if (first || (decides && !checked.verdict.passed))
    findings.insert(findings.end(), checked.findings.begin(), checked.findings.end());
  if (!checked.safeToRun)
    findings.push_back(refusalOf(checked));
}

std::vector<TextLine> linesOfPoints(const CheckedProgram& program,
                                    const plan::Trajectory& trajectory) {
  std::vector<TextLine> lines = program.pointLines;
  lines.resize(trajectory.pointCount());
  return lines;
}

} // namespace voluta::pipeline
