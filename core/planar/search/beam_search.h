// Decomposition into pieces by a beam search over cutting planes.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/planar_decomposition.h"

namespace voluta::planar {

// Cuts the part until the area that needs support is at most options.target of the initial one or
// no cut helps. Several dissimilar partial results are kept, best first (beam-guided cutting: Wu,
// Dai, Fang, Liu, Wang, General support-effective decomposition for multi-directional 3D printing,
// 2019). A plane cuts a piece into the part that stays on its base and the connected part above the
// plane that gains by being printed along the plane's normal. A part that another piece would then
// hide from the head may still be cut off if a cut of that piece, which itself gains nothing, lets
// the hiding part be printed later. If the target is not reached, the search is repeated with
// planes that face up only, on a finer mesh and with less contact kept, and the best result is
// used; what it still leaves above the target is cut by single planes, as far as the head reaches
// all pieces (fineCuts). Cuts do not pass through sections of other cuts (RoboFDM, constraint I).
// The constraint that base planes face up (constraint II) is replaced by the actual condition: the
// head reaches all of a piece past the pieces printed before it. Precondition: `part` is closed,
// faces outward and has its base on z = 0. Same result for any number of threads. Throws
// Error{UnusableInput} if the part is not closed; Cancelled.
// Example:
//   const planar::PlanarDecomposition pieces = planar::beamDecompose(part, {}, ctx);
PlanarDecomposition beamDecompose(const geometry::TriangleMesh& part, const PlanarOptions& options,
                                  const base::RunContext& ctx);

} // namespace voluta::planar
