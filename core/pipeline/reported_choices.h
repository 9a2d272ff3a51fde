// The choices that reports name beside their figures: the preset, the settings that differ from it,
// and the layers before which the operator is awaited.
#pragma once

#include "project/job.h"

#include <string>
#include <vector>

namespace voluta::pipeline {

struct ReportedChoices {
  std::string preset; // its name; the choice itself if there is no such preset
  // "walls=3", or "2:walls=3" of the second part among several; only settings of presets
  std::vector<std::string> changed;
  std::vector<int> pauses; // layers from 1; without pauses for changes of tools
};

ReportedChoices reportedChoices(const project::Job& job);

} // namespace voluta::pipeline
