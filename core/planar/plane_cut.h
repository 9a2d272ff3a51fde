// Cuts of closed meshes by a plane, with identical triangles on both sides of the section.
#pragma once

#include "geometry/triangle_mesh.h"
#include "planar/plane.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace voluta::planar {

// Tag of triangles on the part's own surface; cuts have tags >= 0.
inline constexpr std::int32_t kSkin = -1;
// Tag of triangles on earlier material: formerly the base of a piece that was cut.
inline constexpr std::int32_t kOnPrinted = -3;

// A closed mesh, oriented outward, with any number of components.
struct TaggedMesh {
  geometry::TriangleMesh mesh;
  std::vector<std::int32_t>
      tag; // per triangle: kSkin, kOnPrinted, or the cut whose section it is on
};

TaggedMesh tagged(const geometry::TriangleMesh& mesh);

struct PlaneCut {
  TaggedMesh below;              // may be empty
  std::vector<TaggedMesh> above; // solids, in order of their first triangle
  double sectionMm2 = 0.0;       // area of the section: of the new triangles on either side
  double offsetMm = 0.0;         // of the plane as used: see cutByPlane
};

// Returns whether a solid above the plane is to be cut off; called once for each.
using Wanted = std::function<bool(const TaggedMesh& solid)>;

// Cuts along the plane, closes both sides with the same triangles and separates the wanted solids
// (all if `wanted` is empty; the others remain part of `below`, uncut). The sides together are the
// mesh, without gaps, and each is closed again. The new triangles of above[i] and their
// counterparts below are tagged `tag` + i. Points within 1e-9 of the mesh's size count as on the
// plane; triangles in the plane belong to the side of their solid. If the section touches itself
// and cannot be closed, the plane is moved by up to 1e-4 mm (see offsetMm). Precondition
// (Error{Internal}): one tag per triangle, and every edge of the mesh has as many triangles running
// forward as backward. Throws Error{UnusableInput} if no nearby plane can be closed (the mesh
// intersects itself there).
PlaneCut cutByPlane(const TaggedMesh& mesh, const Plane& plane, std::int32_t tag,
                    const Wanted& wanted = {});

// Returns the same mesh with triangles split where the plane crosses them.
TaggedMesh splitAlong(const TaggedMesh& mesh, const Plane& plane);

// Returns the edge-connected solids in order of their first triangle. A cavity's wall is a
// separate, inside-out component; it stays with the solid that contains it.
std::vector<TaggedMesh> solids(const TaggedMesh& mesh);

// Returns whether every edge has as many triangles running forward as backward.
bool isClosed(const geometry::TriangleMesh& mesh);

} // namespace voluta::planar
