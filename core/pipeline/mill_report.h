// What is written of a milled part.
#pragma once

#include "pipeline/mill_part.h"
#include "project/milled_report.h"

#include <filesystem>

namespace voluta::project {
struct LoadedPart;
}

namespace voluta::pipeline {

// The program's file.
inline constexpr const char* kMillProgramFile = "mill.nc";

// Returns the report of a milled part, without threads and timings.write. `loaded`: the part as
// read. Blocking findings precede the others.
project::MilledReport millReport(const project::LoadedPart& loaded, const MillOrder& order,
                                 const MilledPart& milled);

// Writes report.json, the job (mill_job.h) and, if it passed, the program into the folder, and sets
// the report's timings.write, total and peakRssMb. Throws Error{CannotWrite}.
void writeMilled(project::MilledReport& report, const MillOrder& order, const MilledPart& milled,
                 const std::filesystem::path& folder);

} // namespace voluta::pipeline
