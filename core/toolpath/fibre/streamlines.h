// Evenly spaced streamlines of a field of directions on a patch (Jobard 1997).
#pragma once

#include "base/run_context.h"
#include "toolpath/fibre/tape_curves.h"
#include "toolpath/patch_surface.h"

#include <span>
#include <vector>

namespace voluta::toolpath {

// The direction, regardless of its sign, between the samples of a field: their dyads weighted by
// the inverse square of the distance.
class DirectionField {
public:
  // Precondition: one sample or more.
  explicit DirectionField(std::span<const FieldSample> samples) : samples_(samples) {}
  // Returns the unit direction in the surface at that point, on the side of `ahead`. Zero if the
  // field is normal to the surface.
  Eigen::Vector3d at(const PatchSurface& surface, const SurfacePoint& point,
                     const Eigen::Vector3d& ahead) const;

private:
  std::span<const FieldSample> samples_;
};

// Returns streamlines that are nowhere closer to each other than `apartMm`, and begin at that
// distance beside earlier ones; the first is `firstMm` beside the middle of the patch. Throws
// Cancelled.
std::vector<SurfaceCurve> evenStreamlines(const PatchSurface& surface, const DirectionField& field,
                                          double apartMm, double firstMm,
                                          const base::RunContext& ctx);

} // namespace voluta::toolpath
