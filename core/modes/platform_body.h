// Platforms given as a body: reading the mesh, and placing body and part together.
#pragma once

#include "base/run_context.h"
#include "geometry/placement.h"
#include "geometry/triangle_mesh.h"
#include "project/platform.h"

#include <Eigen/Geometry>
#include <memory>

namespace voluta::modes {

// Returns the platform's body in the file's coordinates, repaired; null if the platform is not a
// body. Throws Error{UnreadableFile, UnusableInput}, also if the mesh is not closed.
std::shared_ptr<const geometry::TriangleMesh> platformBody(const project::Platform& platform,
                                                           const base::RunContext& ctx = {});

// Returns the motion that geometry::place applies: work = motion * (scale * file).
Eigen::Isometry3d motionOf(const geometry::TriangleMesh& mesh, double scale,
                           const geometry::Placement& placement);
// Returns the placement with which geometry::place applies this motion to the mesh.
geometry::Placement placementBy(const geometry::TriangleMesh& mesh, double scale,
                                const Eigen::Isometry3d& motion);
geometry::TriangleMesh moved(const geometry::TriangleMesh& mesh, double scale,
                             const Eigen::Isometry3d& motion);

} // namespace voluta::modes
