// Changes of the tool-paths of a file before they are placed: amounts, turns from layer to layer,
// another ground.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"
#include "sliced/curved_ground.h"

#include <Eigen/Geometry>
#include <optional>

namespace voluta::base {
class RunContext;
}

namespace voluta::sliced {

struct PathShape {
  double amountFactor = 1.0; // Of the beads' areas; > 0
  // Each layer is turned about z against the one below, counterclockwise; after every `reverseMm`
  // of height in the other direction (0: never).
  double rotationPerLayerRad = 0.0, reverseMm = 0.0;
  CurvedGround ground;
  // Then everything is moved by this, e.g. onto a plane of a body.
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();

  bool changesNothing() const;
};

struct ShapedPaths {
  plan::ToolPlan plan;
  geometry::TriangleMesh solid; // What its beads make
  // The body that carries them, closed, facing outward; nullopt on the plate.
  std::optional<geometry::TriangleMesh> ground;
};

// Returns the paths, and the solid that comes with them, in the new shape. The centre of the
// solid's box is moved onto the z axis and its lowest point to z = 0 before anything else. On a
// curved ground long segments are divided, so that they follow it within 0.01 mm; bead heights are
// kept, and areas follow the distance of neighbouring beads. Preconditions (Error{Internal}):
// amountFactor > 0, radius not 0. Throws Error{UnusableInput} if the part does not fit the ground:
// it reaches round more than the half of it, or is higher than a hollow ground's radius; Cancelled.
ShapedPaths shaped(const plan::ToolPlan& plan, const geometry::TriangleMesh& solid,
                   const PathShape& shape, const base::RunContext& ctx);

} // namespace voluta::sliced
