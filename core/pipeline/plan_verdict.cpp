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

PlanVerdict verdictOf(const CheckedProgram& program, const project::Report& report) {
  if (!program.passed)
    return PlanVerdict::Refused;
  return blockersOf(report, program.program.format).empty() ? PlanVerdict::Passed
                                                            : PlanVerdict::Blocked;
}

PlanVerdict verdictOf(const project::Report& report) {
  if (!report.replay.passed)
    return PlanVerdict::Refused;
  return nothingBlocks(report) ? PlanVerdict::Passed : PlanVerdict::Blocked;
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

bool isVerified(const VerifyResult& result) {
  return result.replay.passed && std::ranges::none_of(result.findings, &plan::Finding::blocking);
}

} // namespace voluta::pipeline
