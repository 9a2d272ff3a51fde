// Runs of programs of one plan that have been judged (run.h).
#pragma once

#include <memory>
#include <vector>

namespace voluta::replay {

struct JudgedRun;
using JudgedRuns = std::vector<std::shared_ptr<const JudgedRun>>;

} // namespace voluta::replay
