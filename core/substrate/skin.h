// A skin of layers parallel to the upper surface of a part, over a core that ends below it (curved
// layer deposition: Castelli 2020, 1.3.3; Boge 2020, fig. 3.3).
#pragma once

#include "geometry/triangle_mesh.h"
#include "substrate/level_stack.h"

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

namespace voluta::geometry {
class MeshQuery;
}

namespace voluta::substrate {

struct Skin {
  std::vector<char> faces; // per face of the part, whether the skin follows it
  double depthMm = 0.0;
};

// Returns per face of a part whether it is one of its upper surface: its normal is no farther from
// z than that.
std::vector<char> upperFaces(const geometry::TriangleMesh& part, double maxSlopeRad);
// Returns per face of a part whether at least half of it is painted. `painted`: triangles on the
// part's surface.
std::vector<char> paintedFaces(const geometry::TriangleMesh& part,
                               const geometry::TriangleMesh& painted);

// The surface of a part that a skin follows, for the body of the skin. Where it ends at a ridge, it
// is continued straight ahead, so that the skin ends at the part's side without a bend; elsewhere
// the skin ends along the normals of its edge.
class SkinSurface {
public:
  // Precondition: depthMm > 0; gridMm > 0 is the resolution at which excess() is looked at; an
  // entry for each face.
  SkinSurface(const geometry::TriangleMesh& part, const Skin& skin, double gridMm);

  bool empty() const { return surface_.empty(); }
  // With its continuation.
  const geometry::TriangleMesh& surface() const { return surface_; }
  // Return the distance from the surface less the depth, and how far a point is beyond the skin
  // [mm], which is at least that and negative inside the skin. Precondition: not empty.
  // Thread-safe.
  double excessOfDepth(const Eigen::Vector3d& p) const;
  double excess(const Eigen::Vector3d& p) const;

private:
  geometry::TriangleMesh surface_;
  // Per triangle and side from corner k to k + 1: where the surface ends there without being
  // continued, the unit vector in the triangle's plane that points out; else zero.
  std::vector<std::array<Eigen::Vector3d, 3>> outward_;
  double depthMm_ = 0.0, gridMm_ = 0.0;
  std::shared_ptr<const geometry::MeshQuery> query_;
};

// Returns levels at constant distance from the surface of `part`, the outermost one half a layer
// below it, the innermost on the core, depthMm below it. Directions point to the surface. `solid`:
// what the levels fill. Preconditions: it is not empty; the skin follows a face.
LevelFamily skinLevels(const geometry::TriangleMesh& solid, const geometry::TriangleMesh& part,
                       const Skin& skin, const LevelOptions& options);

// Returns the closed body of all points within depthMm of a surface, on a grid of gridMm.
// Precondition: the surface is not empty, lengths are positive. Throws Cancelled.
geometry::TriangleMesh bodyAround(const geometry::TriangleMesh& surface, double depthMm,
                                  double gridMm, const base::RunContext& ctx);

} // namespace voluta::substrate
