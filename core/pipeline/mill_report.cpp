#include "pipeline/mill_report.h"

#include "base/files.h"
#include "base/memory.h"
#include "base/stopwatch.h"
#include "pipeline/mill_job.h"
#include "pipeline/plan_verdict.h"
#include "pipeline/stages.h"
#include "plan/finding_kinds.h"
#include "program/gcode/gcode_milling.h"
#include "project/loaded_part.h"
#include "project/report_fields.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <type_traits>

namespace voluta::pipeline {

namespace {
using enum plan::FindingKind;

constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

// Sets all figures that are no counts to "none".
template <project::HasFields R> void clearFigures(R& report) {
  project::forEachField<R>([&](const auto& field) {
    auto& value = report.*field.member;
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, double>)
      value = kNoFigure;
    else if constexpr (project::HasFields<Value>)
      clearFigures(value);
  });
}

std::size_t motionsOf(const plan::Findings& findings,
                      std::initializer_list<plan::FindingKind> kinds) {
  std::size_t motions = 0;
  for (const plan::Finding& finding : findings)
    if (std::ranges::find(kinds, finding.kind) != kinds.end())
      motions += finding.count;
  return motions;
}

// Nothing is deposited: figures of beads are none.
project::ReplayReport cutReplayReport(const milling::CutVerdict& verdict) {
  project::ReplayReport report;
  clearFigures(report);
  report.passed = verdict.passed;
  report.collisions = motionsOf(verdict.findings, {RapidInBlock, CutterBelowBlock});
  report.limitViolations = motionsOf(verdict.findings, {SpindleChanged, FeedChanged});
  report.maxDeviationMm = verdict.maxDeviationMm;
  report.controllerDurationS = verdict.seconds;
  report.thresholds.deviationMm = milling::kSamePlaceMm;
  return report;
}

project::ProgramReport programReport(const MilledPart& milled) {
  project::ProgramReport report;
  report.format = program::kMillingFormat;
  report.state = milled.verdict.passed ? "released" : "notWritten";
  if (milled.verdict.passed)
    report.files = {kMillProgramFile};
  report.bytes = milled.program.size();
  report.maxDeviationMm = milled.verdict.maxDeviationMm;
  report.durationS = milled.verdict.seconds;
  report.flowErrorFraction = report.massRatio = kNoFigure;
  return report;
}

project::MillingReport millingReport(const MillOrder& order, const MilledPart& milled) {
  const milling::MillRule& rule = order.rule;
  const milling::CutVerdict& verdict = milled.verdict;
  const Eigen::Quaterniond& rotation = milled.orientation.rotation;
  project::MillingReport report;
  report.material = rule.data.id;
  report.cutterMm = rule.cutter.diameterMm;
  report.teeth = rule.cutter.teeth;
  report.rpm = rule.data.rpm;
  report.feedMmPerMin = milling::feedMmPerMin(rule.cutter, rule.data);
  report.lineMm = rule.distanceMm();
  report.finePassMm = milling::finePassMm(rule.cutter, rule.data);
  report.blockMm = milled.plan.block.sizes();
  report.millingOrientation = {
      .quaternion = {rotation.w(), rotation.x(), rotation.y(), rotation.z()},
      .rounds = milled.orientation.rounds,
      .scrapBeforeMm3 = milled.orientation.scrapBeforeMm3,
      .scrapMm3 = milled.orientation.scrapMm3};
  report.moves = milled.motions;
  report.removedMm3 = verdict.removedMm3;
  report.deepestMm = verdict.deepestMm;
  report.residueMm = std::max(verdict.residueMm, verdict.sideResidueMm);
  report.complete = verdict.isComplete();
  report.leftMm3 = verdict.left.volumeMm3;
  report.leftThickestMm = verdict.left.thickestMm;
  report.leftAtMm = verdict.left.atMm;
  report.cornersMm3 = verdict.left.cornersMm3;
  return report;
}

} // namespace

project::MilledReport millReport(const project::LoadedPart& loaded, const MillOrder& order,
                                 const MilledPart& milled) {
  project::MilledReport report;
  report.model = modelReport(milled.part);
  report.model.file = loaded.name;
  report.model.repairs = loaded.notes;
  report.milling = millingReport(order, milled);
  report.programs = {programReport(milled)};
  report.replay = cutReplayReport(milled.verdict);
  report.verdict = verdictId(milled.verdict.passed ? PlanVerdict::Passed : PlanVerdict::Refused);
  report.safeToRun = report.printsAsAsked = milled.verdict.passed;
  report.findings = defectFindings(loaded.remains);
  report.findings.insert(report.findings.begin(), milled.verdict.findings.begin(),
                         milled.verdict.findings.end());
  report.timings = milled.timings;
  report.timings.load += loaded.readS;
  report.timings.repair = loaded.repairS;
  report.timings.total =
      report.timings.load + report.timings.repair + report.timings.toolpath + report.timings.replay;
  return report;
}

void writeMilled(project::MilledReport& report, const MillOrder& order, const MilledPart& milled,
                 const std::filesystem::path& folder) {
  base::Stopwatch writing;
  base::writeFile(folder / kMillJobFile, writeMillJob(milled.part, order));
  if (milled.verdict.passed)
    base::writeFile(folder / kMillProgramFile, milled.program);
  report.timings.write = writing.seconds();
  report.timings.total += report.timings.write;
  report.peakRssMb = base::peakResidentMb();
  base::writeFile(folder / "report.json", project::reportJson(report));
}

} // namespace voluta::pipeline
