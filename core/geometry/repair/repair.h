// Mends a mesh as far as its shape is not in doubt, and tells what was done.
#pragma once

#include "base/run_context.h"
#include "geometry/repair/diagnosis.h"
#include "geometry/repair/open_surface.h"
#include "geometry/triangle_mesh.h"

#include <optional>
#include <vector>

namespace voluta::geometry {

// What becomes of surfaces that enclose nothing (open_surface.h).
enum class OpenSurfaces {
  Keep, // they stay as they are, and RepairResult::open says so
  Close // rims are closed whatever their size, sheets are left out
};

struct RepairResult {
  TriangleMesh mesh;
  std::vector<base::Message> repairs; // what was done, a sentence each; empty when nothing was
  std::vector<base::Message> remains; // what could not be mended, a sentence each; of a mesh that
                                      // was kept open, that it is
  Diagnosis diagnosis;                // of `mesh`
  Diagnosis found;                    // of the mesh as it came
  std::optional<OpenSurface> open;    // set if the mesh was kept open
};

// In this order, each only where the diagnosis asks for it: near-duplicate points merged (up to
// 3e-4 of the diagonal, never more than a third of a short edge), triangles without area, doubled
// triangles and loose sheets dropped, T-junctions split, triangles turned to agree, non-manifold
// edges separated, holes closed (Liepa 2003 as in CGAL), inside-out components turned (cavities
// stay cavities), components that overlap or cut themselves united (winding_union.h) unless that
// would drop more than one part in a hundred of what they enclose.
// A mesh that is clean comes back unchanged. One that cannot be made watertight comes back as far
// as it was mended, with diagnosis.watertight false; the winding number still tells its inside.
// With OpenSurfaces::Keep, rims at which the surface ends and sheets stay as they are where they
// are more than one part in a hundred of the surface.
// Cancels between steps and within the long ones.
// Precondition (Error{Internal}): indices in range, coordinates finite.
// Throws Error{UnusableInput}: nothing with area is left.
// Example:
//   const geometry::MeshFile file = geometry::readMesh(stl);
//   const geometry::RepairResult mended = geometry::repair(file.mesh);
//   const geometry::TriangleMesh part = geometry::placeOnPlate(mended.mesh, 1.0);
RepairResult repair(const TriangleMesh& mesh, const base::RunContext& ctx = {},
                    OpenSurfaces how = OpenSurfaces::Keep);

} // namespace voluta::geometry
