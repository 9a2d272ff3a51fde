// The plan of one part of a job.
#pragma once

#include "pipeline/plan_result.h"

#include <cstddef>

namespace voluta::document {

// Returns the plan with only that item's choices, results and figures, as of a job of one part.
// Keys, findings and the results of the whole job stay. Precondition: the plan has the item.
pipeline::PlanResult onlyItem(const pipeline::PlanResult& plan, std::size_t item);

} // namespace voluta::document
