#include "toolpath/infill/thin_walls.h"

#include "toolpath/infill/curve_tools.h"

namespace voluta::toolpath {

std::optional<ThinWall> thinWallAlong(const PatchSurface& s, const SurfaceCurve& curve,
                                      const std::vector<double>& boundaryMm, double narrowestMm) {
  // Distances at vertices are a little too small beside a ridge.
  constexpr double kClearlyNarrower = 0.93;
  if (curve.points.size() < 2)
    return std::nullopt;
  double sum = 0.0;
  for (const SurfacePoint& p : curve.points)
    sum += s.interpolate(boundaryMm, p);
  const double width = 2.0 * sum / static_cast<double>(curve.points.size());
  if (width > kClearlyNarrower * narrowestMm)
    return std::nullopt;
  return ThinWall{lengthOf(curve), width, curve.points[curve.points.size() / 2].position};
}

} // namespace voluta::toolpath
