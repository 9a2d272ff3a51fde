// A verdict, and the place of a finding, in a few words.
#pragma once

#include "pipeline/plan_verdict.h"
#include "plan/finding_kinds.h"

#include <fmt/format.h>
#include <string>

namespace voluta::cli {

inline const char* verdictWords(pipeline::PlanVerdict verdict) {
  switch (verdict) {
  case pipeline::PlanVerdict::Passed:
    return "passed";
  case pipeline::PlanVerdict::NotAsAsked:
    return "safe to run, NOT as asked";
  case pipeline::PlanVerdict::Unchecked:
    return "safe to run but for your own statements";
  case pipeline::PlanVerdict::Blocked:
    return "passed, the plan NOT";
  case pipeline::PlanVerdict::Refused:
    break;
  }
  return "refused";
}

// Begins the line of a finding that is no danger, beside programs that are safe to run.
inline const char* amberWords(const plan::Finding& finding) {
  if (finding.kind == plan::FindingKind::OwnStatement)
    return "not checked: ";
  return finding.blocking && !plan::blocksRunning(finding) ? "not as asked: " : "";
}

// Ends the line of a finding that has a place [mm].
inline std::string placeWords(const plan::Finding& finding) {
  return finding.where ? fmt::format(" at ({:.1f}, {:.1f}, {:.1f})", finding.where->x(),
                                     finding.where->y(), finding.where->z())
                       : std::string();
}

} // namespace voluta::cli
