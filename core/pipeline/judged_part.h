// The part that a replay judges.
#pragma once

#include <memory>

namespace voluta::geometry {
struct TriangleMesh;
}
namespace voluta::project {
struct Job;
}

namespace voluta::pipeline {

struct Resolved;

// Returns project::printedOf(), with the sizes of items in flat layers corrected as the process of
// their tool states (planar/slicing/corrected_mesh.h). The triangles keep their numbers.
std::shared_ptr<const geometry::TriangleMesh> judgedPart(const project::Job& job,
                                                         const Resolved& resolved);

} // namespace voluta::pipeline
