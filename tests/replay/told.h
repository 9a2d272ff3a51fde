// A verdict in words, for messages of tests.
#pragma once

#include "plan/finding_kinds.h"
#include "replay/verification.h"

#include <string>

namespace voluta::replay {

inline std::string findingsText(const Verification& v) {
  std::string all;
  for (const auto& f : v.findings)
    all += plan::reportId(f) + ": " + voluta::plan::englishReason(f) + "\n";
  for (const auto& r : v.results)
    all += r.name + " " + std::to_string(r.value) + (r.passed ? "" : " FAILED") + "\n";
  return all;
}

} // namespace voluta::replay
