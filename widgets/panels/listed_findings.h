// Findings as they stand in a list: a fact once, whichever programs it was found in.
#pragma once

#include "plan/finding.h"

#include <string>
#include <vector>

namespace voluta::panels {

struct ListedFinding {
  plan::Finding finding;            // as the first of the programs has it
  std::vector<std::string> formats; // of the programs; empty: it is not about programs
};

// In the same order. Two programs tell the same fact where kind, place (within 0.1 mm) and all that
// is no amount agree: what was measured differs a little from one to the other. That a program is
// refused is left out where a finding says why.
std::vector<ListedFinding> listed(const plan::Findings& findings);

} // namespace voluta::panels
