#include "pipeline/plan_verdict.h"

#include "pipeline/checked_program.h"
#include "pipeline/road.h"
#include "plan/finding_kinds.h"
#include "process/tooling.h"

#include <algorithm>
#include <iterator>
#include <variant>

namespace voluta::pipeline {

std::string formatOf(const plan::Finding& finding) {
  if (!finding.program.format.empty())
    return finding.program.format;
  const base::Value* value = finding.value("format");
  const auto* format = value ? std::get_if<std::string>(&value->data()) : nullptr;
  return format ? *format : std::string();
}

std::vector<plan::Finding> blockersOf(const project::Report& report, const std::string& format) {
  std::vector<plan::Finding> blockers;
  std::ranges::copy_if(report.findings, std::back_inserter(blockers),
                       [&](const plan::Finding& finding) {
                         const std::string of = formatOf(finding);
                         return finding.blocking && (of.empty() || of == format);
                       });
  return blockers;
}

const plan::Finding* firstBlocking(const plan::Findings& findings) {
  auto found = std::ranges::find_if(findings, plan::blocksRunning);
  if (found == findings.end())
    found = std::ranges::find_if(findings, &plan::Finding::blocking);
  return found == findings.end() ? nullptr : &*found;
}

namespace {
PlanVerdict verdictOn(bool isSafe, bool passed, const plan::Findings& findings) {
  if (!isSafe)
    return PlanVerdict::Refused;
  if (std::ranges::any_of(findings, plan::blocksRunning))
    return PlanVerdict::Blocked;
  const auto isUnchecked = [](const plan::Finding& finding) {
    return finding.blocking && finding.kind == plan::FindingKind::OwnStatement;
  };
  if (std::ranges::any_of(findings, isUnchecked))
    return PlanVerdict::Unchecked;
  return passed && std::ranges::none_of(findings, &plan::Finding::blocking)
             ? PlanVerdict::Passed
             : PlanVerdict::NotAsAsked;
}

bool isSafe(const project::ReplayReport& replay) {
  return replay.safeToRun || replay.passed; // older reports have the second only
}
} // namespace

PlanVerdict verdictOf(const CheckedProgram& program, const project::Report& report) {
  return verdictOn(program.safeToRun, program.verdict.passed,
                   blockersOf(report, program.program.format));
}

PlanVerdict verdictOf(const project::Report& report) {
  return verdictOn(isSafe(report.replay), report.replay.passed, report.findings);
}

bool isRefused(PlanVerdict verdict) {
  return verdict == PlanVerdict::Refused || verdict == PlanVerdict::Blocked;
}

std::string verdictId(PlanVerdict verdict) {
  switch (verdict) {
  case PlanVerdict::Passed:
    return "passed";
  case PlanVerdict::NotAsAsked:
    return "differs";
  case PlanVerdict::Unchecked:
    return "unchecked";
  case PlanVerdict::Blocked:
    return "blocked";
  case PlanVerdict::Refused:
    break;
  }
  return "refused";
}

project::VerdictReport verdictReport(const project::Report& report) {
  if (report.programs.empty())
    return {};
  const PlanVerdict verdict = verdictOf(report);
  const bool passed = verdict == PlanVerdict::Passed;
  return {verdictId(verdict), passed || verdict == PlanVerdict::NotAsAsked, passed};
}

double bridgedMm(const CheckedProgram& program, const process::Tooling& tooling) {
  for (const plan::Finding& finding : program.findings)
    if (finding.kind == plan::FindingKind::LongBridge)
      if (const base::Value* bridge = finding.value("bridge"))
        if (const auto* mm = std::get_if<base::Quantity>(&bridge->data()))
          return mm->number;
  double maximum = 0.0;
  for (const process::Tool& tool : tooling.tools())
    maximum = std::max(maximum, tool.process.bridgeMm);
  return maximum;
}

PlanVerdict verdictOf(const VerifyResult& result) {
  return verdictOn(isSafe(result.replay), result.replay.passed, result.findings);
}

} // namespace voluta::pipeline
