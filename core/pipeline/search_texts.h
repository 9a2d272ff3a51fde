// Texts about mode auto's search, shared by the command line and the window.
#pragma once

#include "base/text.h"
#include "pipeline/road.h"
#include "project/report.h"

#include <vector>

namespace voluta::pipeline {

// Returns "Trying pieces (2 of 4)".
base::Message tryingText(const StrategyProgress& strategy);

// Returns "Chosen: flat layers with supports" with the values used, or a text that no way passes.
// Precondition: mode auto has tried at least one way for the part.
base::Message chosenText(const project::ItemReport& item);

// Returns one sentence for each way that was tried and not chosen: its name and why.
std::vector<base::Message> rejectedTexts(const project::ItemReport& item);

} // namespace voluta::pipeline
