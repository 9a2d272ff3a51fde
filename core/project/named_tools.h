// Checks the tools and items that a planned job names.
#pragma once

#include "project/job.h"

namespace voluta::project {

// Returns whether all tools and items that layers, tool-paths and motion name are among the
// choices.
bool namesKnownOnes(const Job& job);

} // namespace voluta::project
