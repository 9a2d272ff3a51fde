// Repairs a mesh as far as its shape is not in doubt, and reports the changes.
#pragma once

#include "base/run_context.h"
#include "geometry/repair/diagnosis.h"
#include "geometry/repair/open_surface.h"
#include "geometry/triangle_mesh.h"

#include <optional>
#include <vector>

namespace voluta::geometry {

// Treatment of surfaces that enclose nothing (open_surface.h).
enum class OpenSurfaces {
  Keep, // not changed; reported in RepairResult::open
  Close // rims are closed regardless of size, sheets are removed
};

struct RepairResult {
  TriangleMesh mesh;
  std::vector<base::Message> repairs; // repairs made, one sentence each; empty if there were none
  // defects that could not be repaired, one sentence each; includes that the mesh was kept open
  std::vector<base::Message> remains;
  Diagnosis diagnosis;             // of `mesh`
  Diagnosis found;                 // of the original mesh
  std::optional<OpenSurface> open; // set if the mesh was kept open
};

// Performs these steps in order, each only if the diagnosis requires it: merges near-duplicate
// points (up to 3e-4 of the diagonal, never more than a third of a short edge), drops triangles
// without area, duplicate triangles and loose sheets, splits T-junctions, orients triangles
// consistently, separates non-manifold edges, closes holes (Liepa 2003 as in CGAL), flips
// inside-out components (cavities stay cavities), and unites components that overlap or intersect
// themselves (winding_union.h). It does not unite them where that would drop more than one percent
// of the enclosed volume, or with more than 250,000 pairs of intersecting triangles, which would
// take minutes; `remains` says so.
// A clean mesh is returned unchanged. A mesh that cannot be made watertight is returned as far as
// it was repaired, with diagnosis.watertight false; the winding number still defines its inside.
// With OpenSurfaces::Keep, rims at which the surface ends and sheets are not changed if they make
// up more than one percent of the surface. Can be cancelled between steps and within the long ones.
// Precondition (Error{Internal}): indices in range, coordinates finite. Throws Error{UnusableInput}
// if nothing with area is left.
// Example:
//   const geometry::MeshFile file = geometry::readMesh(stl);
//   const geometry::RepairResult mended = geometry::repair(file.mesh);
//   const geometry::TriangleMesh part = geometry::placeOnPlate(mended.mesh, 1.0);
RepairResult repair(const TriangleMesh& mesh, const base::RunContext& ctx = {},
                    OpenSurfaces how = OpenSurfaces::Keep);

} // namespace voluta::geometry
