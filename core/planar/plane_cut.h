// Closed meshes cut by a plane, matched exactly on both sides.
#pragma once

#include "geometry/triangle_mesh.h"
#include "planar/plane.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace voluta::planar {

// A triangle's tag of a part's own surface; cuts have tags >= 0.
inline constexpr std::int32_t kSkin = -1;
// And of what lies on material that is printed before: once the base of a piece that was cut.
inline constexpr std::int32_t kLaid = -3;

// A closed mesh, oriented outward, of any number of components.
struct TaggedMesh {
  geometry::TriangleMesh mesh;
  std::vector<std::int32_t> tag; // per triangle: kSkin, kLaid, or the cut whose section it lies on
};

TaggedMesh tagged(const geometry::TriangleMesh& mesh);

struct PlaneCut {
  TaggedMesh below;              // may be empty
  std::vector<TaggedMesh> above; // solids, in order of their first triangle
  double sectionMm2 = 0.0;       // area of the section: of the new triangles on either side
  double offsetMm = 0.0;         // of the plane as cut: see cutByPlane
};

// Which of the solids above a plane are to be cut off: asked once for each.
using Wanted = std::function<bool(const TaggedMesh& solid)>;

// Cuts along the plane, closes both sides with the same triangles and takes the wanted solids off
// (all where `wanted` is empty; the others stay with what is below, uncut): the sides together are
// the mesh, nothing between them, and each is closed again. The new triangles of above[i] and what
// they lie on are tagged `tag` + i. Points no further
// from the plane than 1e-9 of the mesh's size count as on it; triangles that lie on it belong to
// the side that their solid is on. Where the section touches itself so that it could not be
// closed, the plane is moved by up to 1e-4 mm (offsetMm tells). Precondition (Error{Internal}): a
// tag a triangle, every edge of the mesh has as many triangles running forward as backward. Throws
// Error{UnusableInput} where no nearby plane can be closed (a mesh that cuts itself there).
PlaneCut cutByPlane(const TaggedMesh& mesh, const Plane& plane, std::int32_t tag,
                    const Wanted& wanted = {});

// The same mesh, its triangles split where the plane crosses them.
TaggedMesh splitAlong(const TaggedMesh& mesh, const Plane& plane);

// Parts that hang together by shared edges, in order of their first triangle. A cavity's wall is
// a component of its own, inside out: it goes with the solid that holds it.
std::vector<TaggedMesh> solids(const TaggedMesh& mesh);

// Whether every edge has as many triangles running forward as backward.
bool isClosed(const geometry::TriangleMesh& mesh);

} // namespace voluta::planar
