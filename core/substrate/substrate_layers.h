// Layers on a given surface.
#pragma once

#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "geometry/triangle_mesh.h"
#include "substrate/ground_distance.h"
#include "substrate/level_stack.h"

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>

namespace voluta::substrate {

enum class LevelShape {
  Offset,   // at constant distance from the surface
  Sphere,   // spheres about a centre (Castelli 2020, 1.3.3)
  Cylinder, // cylinders about an axis along x
  Flatten   // from the surface to an end surface, thickness varying over a layer (5.2.3)
};

// Where Flatten ends.
struct EndSurface {
  std::optional<double> heightMm; // of its top; none: the part's highest point
  // Of a cylinder along x, over one that the part stands on; infinite: a plane.
  double radiusMm = std::numeric_limits<double>::infinity();
  std::shared_ptr<const geometry::MeshQuery> mesh; // instead of both
};

struct SubstrateOptions : LevelOptions {
  LevelShape shape = LevelShape::Offset;
  // Of spheres, and (y, z) of cylinders; none: of the ball or cylinder that the part stands on;
  // where it stands on neither, under the part's middle, half its height below its foot.
  std::optional<Eigen::Vector3d> centre;
  EndSurface end;
};

// What is to be laid on a body: the part less it. Throws Error{UnusableInput} where the part is not
// closed, or nothing of it is outside the body.
geometry::TriangleMesh partOnBody(const geometry::TriangleMesh& part,
                                  const geometry::TriangleMesh& body);

// The plate z = 0 as a ground.
GroundDistance plateGround();

// The levels of `part`, which stands on the ground. Throws Error{UnusableInput}: no room for a
// layer; Flatten: an end surface that nothing of the surface reaches, no number of layers within
// the limits of thickness, layers that would fold; Cancelled.
LevelFamily substrateLevels(const geometry::TriangleMesh& part, const GroundDistance& ground,
                            const SubstrateOptions& options, const base::RunContext& ctx);

} // namespace voluta::substrate
