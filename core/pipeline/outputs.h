// What a plan leaves in its folder (DESIGN §5).
#pragma once

#include "base/run_context.h"
#include "pipeline/road.h"

#include <filesystem>

namespace voluta::pipeline {

// job.voluta, report.json, the programs and, where asked for, what every stage made. Fills in
// report.timings.write and peakRssMb first. Throws Error{CannotWrite}.
void writeOutputs(PlanResult& result, const std::filesystem::path& folder,
                  const base::RunContext& ctx);

} // namespace voluta::pipeline
