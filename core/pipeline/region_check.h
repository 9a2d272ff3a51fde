// Checks the regions of an item before a plan.
#pragma once

namespace voluta::base {
class ParameterTable;
}
namespace voluta::project {
struct ItemChoices;
}

namespace voluta::pipeline {

// Throws Error{Usage} that names the region, if its shape, its use or a setting is invalid, or if a
// setting is none that a region may have. `table`: all parameters.
void checkRegions(const project::ItemChoices& item, const base::ParameterTable& table);

} // namespace voluta::pipeline
