// Findings of the stages, and whether they still apply.
#pragma once

#include "plan/finding.h"
#include "project/job_stage.h"

#include <vector>

namespace voluta::document {

class Document;

struct DatedFinding {
  plan::Finding finding;
  bool outOfDate = false; // found before the last change of the choices
};

// Returns the findings of the shown results of every stage, in the order of the stages. While
// voxels are being computed, their findings replace the previous ones of that stage.
std::vector<DatedFinding> datedFindings(const Document& document);

// Returns the stages that have not checked the present choices: the absence of findings there means
// nothing. All stages if there is no part.
std::vector<project::Stage> uncheckedStages(const Document& document);

} // namespace voluta::document
