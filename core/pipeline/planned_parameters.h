// The settings of layers and tool-paths that the program plans. They have no effect on a part that
// is printed along the tool-paths of its file: the window hides them and a plan notes them.
#pragma once

#include "base/parameters.h"
#include "base/text.h"

#include <vector>

namespace voluta::modes {
struct Mode;
}

namespace voluta::pipeline {

struct Resolved;

// Returns the settings of planned layers and tool-paths. A mode that places the part or makes its
// platform takes its own settings for that too; they are not among them.
base::ParameterTable plannedParameters(const modes::Mode& mode);

// Returns a sentence that names the settings without effect that were changed for a part with given
// tool-paths; empty: none. Settings of the job may matter to the other parts, if there are any.
std::vector<base::Message> noEffectNotes(const Resolved& resolved);

} // namespace voluta::pipeline
