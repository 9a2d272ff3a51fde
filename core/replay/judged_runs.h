// Judged runs of programs of one plan (run.h).
#pragma once

#include <memory>
#include <vector>

namespace voluta::replay {

struct JudgedRun;
using JudgedRuns = std::vector<std::shared_ptr<const JudgedRun>>;

} // namespace voluta::replay
