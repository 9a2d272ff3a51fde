// Plans the rest of a stopped station: each machine goes on from its own place, and all rests are
// planned together.
#pragma once

#include "base/run_context.h"
#include "pipeline/resume.h"
#include "pipeline/station_plan.h"
#include "project/station.h"

#include <vector>

namespace voluta::pipeline {

// Where a machine goes on. Exactly one is set, as in ResumeRequest; a line is of the machine's
// program that is replayed together with the others.
struct ResumePlace {
  std::optional<std::size_t> bead = {}, line = {};
};

// Plans the rests from the jobs of a station and joins them. `folder`: with the programs, as
// writeStationOutputs() filled it. A machine that finds no way to its place gives a finding, and
// the station no programs. Throws Error{Usage} unless there is a place for each machine, and as
// resumePrint() and planStation().
StationResult resumeStation(project::Station station, const std::vector<ResumePlace>& places,
                            const std::filesystem::path& folder, const base::RunContext& ctx);

} // namespace voluta::pipeline
