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
  Offset,   // At constant distance from the surface
  Sphere,   // Spheres around a centre (Castelli 2020, 1.3.3)
  Cylinder, // Cylinders around an axis along x
  Flatten   // From the surface to an end surface, with thickness varying over a layer (5.2.3)
};

// Where Flatten ends.
struct EndSurface {
  std::optional<double> heightMm; // Of its top; nullopt: the part's highest point
  // Radius of a cylinder along x, if the part rests on one; infinite: a plane.
  double radiusMm = std::numeric_limits<double>::infinity();
  std::shared_ptr<const geometry::MeshQuery> mesh; // Replaces the other two
};

struct SubstrateOptions : LevelOptions {
  LevelShape shape = LevelShape::Offset;
  // Centre of spheres, or (y, z) of cylinders. nullopt: that of the ball or cylinder on which the
  // part rests; without either, half the part's height below the middle of its foot.
  std::optional<Eigen::Vector3d> centre;
  EndSurface end;
};

// Returns the part without the body. Throws Error{UnusableInput} if the part is not closed, or the
// body contains all of it.
geometry::TriangleMesh partOnBody(const geometry::TriangleMesh& part,
                                  const geometry::TriangleMesh& body);

// Returns the plate z = 0 as a ground.
GroundDistance plateGround();

// Returns the levels of `part`, which rests on the ground. Throws Error{UnusableInput} if there is
// no room for a layer; for Flatten, if the end surface is out of reach of the surface, no number of
// layers is within the thickness limits, or layers would fold. Throws Cancelled.
LevelFamily substrateLevels(const geometry::TriangleMesh& part, const GroundDistance& ground,
                            const SubstrateOptions& options, const base::RunContext& ctx);

} // namespace voluta::substrate
