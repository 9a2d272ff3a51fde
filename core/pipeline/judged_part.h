// The part that a replay judges.
#pragma once

#include "base/parameters.h"
#include "geometry/triangle_mesh.h"
#include "process/tooling.h"
#include "project/job.h"

#include <memory>

namespace voluta::pipeline {

// Returns project::printedOf(), with the sizes of items in flat layers corrected as the process of
// their tool states (planar/slicing/corrected_mesh.h). The triangles keep their numbers.
std::shared_ptr<const geometry::TriangleMesh> judgedPart(const project::Job& job,
                                                         const process::Tooling& tooling,
                                                         const base::ParameterValues& values);

} // namespace voluta::pipeline
