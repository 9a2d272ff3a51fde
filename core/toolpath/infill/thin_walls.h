// Walls of the part that are narrower than the narrowest bead.
#pragma once

#include "toolpath/patch_surface.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace voluta::toolpath {

struct ThinWall {
  double lengthMm = 0.0, widthMm = 0.0; // Mean width
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

// Returns the wall whose middle the curve follows, or nullopt unless that wall is narrower than
// `narrowestMm`, the hatch of the narrowest bead. boundaryMm: per vertex, distance to the patch's
// boundary.
std::optional<ThinWall> thinWallAlong(const PatchSurface& surface, const SurfaceCurve& curve,
                                      const std::vector<double>& boundaryMm, double narrowestMm);

} // namespace voluta::toolpath
