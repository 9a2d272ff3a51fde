// Verifies the programs of a station, from disk.
#pragma once

#include "base/run_context.h"
#include "pipeline/road.h"
#include "plan/finding.h"
#include "replay/shared_run.h"

#include <filesystem>
#include <vector>

namespace voluta::pipeline {

struct StationCheck {
  // Per machine: the first file of its program, and that program alone, against its job.
  std::vector<std::filesystem::path> programs;
  std::vector<VerifyResult> alone;
  replay::SharedRun replay; // of all programs in one time
  plan::Findings findings;  // of the station; machines that were refused and the common run
};

// Reads the station and the programs in a folder that writeStationOutputs() filled, verifies each
// against its job, its marks included, and replays all in one time. `folder`: or the project of the
// station in it. Throws Error{UnreadableFile} for a missing file, Error{UnusableInput} if it is of
// one machine, or a machine has no program; Cancelled.
StationCheck verifyStation(const std::filesystem::path& folder, const base::RunContext& ctx);

} // namespace voluta::pipeline
