// Evenly spaced streamlines of a field of directions on a patch (Jobard 1997).
#pragma once

#include "base/run_context.h"
#include "toolpath/options.h"
#include "toolpath/patch_surface.h"

#include <utility>
#include <vector>

namespace voluta::toolpath {

// The direction of a field in a surface, regardless of its sign.
class DirectionField {
public:
  explicit DirectionField(StrandDyads dyads) : dyads_(std::move(dyads)) {}
  // Returns the unit direction in the surface at that point, on the side of `ahead`. Zero if the
  // field is normal to the surface.
  Eigen::Vector3d at(const PatchSurface& surface, const SurfacePoint& point,
                     const Eigen::Vector3d& ahead) const;

private:
  StrandDyads dyads_;
};

// Returns streamlines that are nowhere closer to each other than `apartMm`, and begin at that
// distance beside earlier ones; the first is `firstMm` beside the middle of the patch. Throws
// Cancelled.
std::vector<SurfaceCurve> evenStreamlines(const PatchSurface& surface, const DirectionField& field,
                                          double apartMm, double firstMm,
                                          const base::RunContext& ctx);

} // namespace voluta::toolpath
