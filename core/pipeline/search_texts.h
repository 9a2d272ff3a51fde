// What mode auto says about its search: the same words on the command line and in the window.
#pragma once

#include "base/text.h"
#include "pipeline/road.h"
#include "project/report.h"

#include <vector>

namespace voluta::pipeline {

// Returns "Trying pieces (2 of 4)".
base::Message tryingText(const WayInTurn& way);

// Returns "Chosen: flat layers with supports" or that nothing passes, with the values used.
// Precondition: mode auto has tried something.
base::Message chosenText(const project::Report& report);

// Returns one sentence for each way that was tried and not chosen: its name and why.
std::vector<base::Message> rejectedTexts(const project::Report& report);

} // namespace voluta::pipeline
