// How the patches of an item, or of one of its regions, are covered.
#pragma once

#include "process/tooling.h"
#include "toolpath/options.h"

namespace voluta::toolpath {

struct CoverRules {
  ToolpathOptions options;
  process::Tooling tooling; // the job's, with the layer height, bead width and step of the item
};

} // namespace voluta::toolpath
