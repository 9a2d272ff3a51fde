// Pieces found by a beam search over cutting planes.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/decomposition.h"

namespace voluta::planar {

// Cuts the part until what needs support is no more than options.target of what it was, or nothing
// helps: several partial results are kept side by side, best first but no two alike (beam-guided
// cutting: Wu, Dai, Fang, Liu, Wang, General support-effective decomposition for multi-directional
// 3D printing, 2019). A piece is cut by a plane into what stays on its base and what hangs together
// above the plane and gains by the plane's normal as its direction. What would then be hidden from
// the head by another piece may still be cut off where a cut of that piece, which itself gains
// nothing, lets what hides it be printed later. Where all that does not reach the target, it is
// tried again with planes that face up only, on a finer mesh and with less of the foot kept, and
// the best is taken. Cuts through sections of other cuts are not made (RoboFDM, constraint I); that
// base planes face up (constraint II) is given up for the real test: the head, as it is, reaches
// all of a piece past what is printed before it. `part` is closed, faces outward and stands on z =
// 0. Same result for any number of threads. Throws Error{UnusableInput} where the part is not
// closed; Cancelled.
// Example:
//   const planar::PlanarDecomposition pieces = planar::beamDecompose(part, {}, ctx);
PlanarDecomposition beamDecompose(const geometry::TriangleMesh& part, const PlanarOptions& options,
                                  const base::RunContext& ctx);

} // namespace voluta::planar
