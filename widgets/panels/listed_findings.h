// Findings as shown in a list: each fact once, with all programs in which it was found.
#pragma once

#include "plan/finding.h"

#include <string>
#include <vector>

namespace voluta::panels {

struct ListedFinding {
  plan::Finding finding;            // that of the first program
  std::vector<std::string> formats; // of the programs; empty: it does not concern programs
  plan::Findings places = {};       // byFact(): all findings of the row, `finding` first
};

// Returns the findings in the same order. Findings of two programs are merged if kind, place
// (within 0.1 mm) and all values except measured amounts, which differ slightly, agree. That a
// program is refused is omitted if another finding gives the reason.
std::vector<ListedFinding> listed(const plan::Findings& findings);
// Returns one row for each fact: rows that differ only by their place, their time and measured
// amounts are merged into the first of them, whose `places` then has all their findings.
std::vector<ListedFinding> byFact(std::vector<ListedFinding> rows);

} // namespace voluta::panels
