// From a file to a sound mesh on the plate.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "pipeline/report.h"

#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

// Parts that the program makes itself, to be named "sample:NAME".
std::vector<std::string> sampleNames();

struct LoadedPart {
  std::string name;                 // file name without folder; "vase.stl" for sample:vase
  geometry::TriangleMesh mesh;      // repaired, as it lies in the file
  std::vector<std::string> notes;   // what was found and mended, a sentence each
  std::vector<std::string> remains; // what could not be mended, a sentence each
};

// Reads and repairs. `part` is a path or "sample:NAME". Throws Error{UnreadableFile,
// UnusableInput}; Error{Usage} for an unknown sample.
LoadedPart loadPart(const std::string& part, Timings& timings, const base::RunContext& ctx);

// The loaded mesh scaled and put on the plate; what the report says of it, defects that remain
// among its findings.
std::shared_ptr<const geometry::TriangleMesh> placePart(const LoadedPart& part, double scale,
                                                        Report& report);

} // namespace voluta::pipeline
