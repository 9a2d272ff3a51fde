// What the stages have found, and whether it still holds.
#pragma once

#include "plan/finding.h"
#include "project/stage.h"

#include <vector>

namespace voluta::document {

class Document;

struct DatedFinding {
  plan::Finding finding;
  bool outOfDate = false; // found before the choices were what they are now
};

// Of what is on show of every stage, in the order of the stages; of voxels that are being made,
// where there are any, instead of those from before.
std::vector<DatedFinding> datedFindings(const Document& document);

// Stages that have not looked at the choices as they are now: that nothing was found there says
// nothing. All of them without a part.
std::vector<project::Stage> uncheckedStages(const Document& document);

} // namespace voluta::document
