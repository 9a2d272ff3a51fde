// What a plan leaves in its folder (docs/design.md, Command line).
#pragma once

#include "base/run_context.h"
#include "pipeline/road.h"

#include <filesystem>
#include <string>

namespace voluta::pipeline {

// The name under which a program's file is written: "refused-" before it where the replay refused
// it.
std::string writtenName(const CheckedProgram& program, const plan::ProgramFile& file);

// job.voluta, report.json, the programs and, where asked for, what every stage made. Fills in
// the report's timings.write and peakRssMb. Throws Error{CannotWrite}.
void writeOutputs(PlanResult& result, const std::filesystem::path& folder,
                  const base::RunContext& ctx);

} // namespace voluta::pipeline
