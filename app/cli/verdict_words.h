// A verdict in a few words.
#pragma once

#include "pipeline/plan_verdict.h"

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

} // namespace voluta::cli
