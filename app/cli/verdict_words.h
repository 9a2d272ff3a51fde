// A verdict in a few words.
#pragma once

#include "pipeline/plan_verdict.h"
#include "plan/finding_kinds.h"

namespace voluta::cli {

inline const char* verdictWords(pipeline::PlanVerdict verdict) {
  switch (verdict) {
  case pipeline::PlanVerdict::Passed:
    return "passed";
  case pipeline::PlanVerdict::NotAsAsked:
    return "safe to run, NOT as asked";
  case pipeline::PlanVerdict::Blocked:
    return "passed, the plan NOT";
  case pipeline::PlanVerdict::Refused:
    break;
  }
  return "refused";
}

// Begins the line of a finding by which a part differs, beside programs that are safe to run.
inline const char* amberWords(const plan::Finding& finding) {
  return finding.blocking && !plan::blocksRunning(finding) ? "not as asked: " : "";
}

} // namespace voluta::cli
