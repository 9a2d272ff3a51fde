// The middle of a share on a line that bends.
#pragma once

#include "toolpath/coverage/voronoi_shares.h"
#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// Returns, per segment of the curve, the distance [mm], positive to the left, from the curve to the
// middle between the extents of its share to both sides. On a straight line it is the mean distance
// of the share's samples. Inside of a bend the share becomes narrower with the distance from the
// line, so that its mean is nearer than its middle: a bead around the mean would leave the centre
// of a small ring open. `share`: of the curve, one value per segment.
std::vector<double> middleOfExtents(const PatchSurface& surface, const SurfaceCurve& curve,
                                    const CellShare& share);

} // namespace voluta::toolpath
