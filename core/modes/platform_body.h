// A platform that is a body: its file, and where that puts it and the part.
#pragma once

#include "base/run_context.h"
#include "geometry/placement.h"
#include "geometry/triangle_mesh.h"
#include "project/platform.h"

#include <Eigen/Geometry>
#include <memory>

namespace voluta::modes {

// A platform's body as the file has it, mended; null for others. Throws
// Error{UnreadableFile, UnusableInput} also where it is not closed.
std::shared_ptr<const geometry::TriangleMesh> platformBody(const project::Platform& platform,
                                                           const base::RunContext& ctx = {});

// The motion of geometry::place: work = motion * (scale * file).
Eigen::Isometry3d motionOf(const geometry::TriangleMesh& mesh, double scale,
                           const geometry::Placement& placement);
// The placement that moves a mesh so.
geometry::Placement placementBy(const geometry::TriangleMesh& mesh, double scale,
                                const Eigen::Isometry3d& motion);
geometry::TriangleMesh moved(const geometry::TriangleMesh& mesh, double scale,
                             const Eigen::Isometry3d& motion);

} // namespace voluta::modes
