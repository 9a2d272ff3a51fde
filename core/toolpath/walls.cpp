#include "toolpath/walls.h"

#include "toolpath/curve_tools.h"
#include "toolpath/surface_fields.h"

namespace voluta::toolpath {

std::vector<SurfaceCurve> wallAt(const PatchSurface& s, const std::vector<double>& depth,
                                 const std::vector<double>& hatchMm, double level) {
  constexpr double kInwards = 0.4;  // hatches
  constexpr double kFar = 4.0;      // mm
  constexpr double kShortest = 1.5; // mm: shorter rings are no more than a blob
  const auto inner = isolines(s, depth, level + kInwards);
  if (inner.empty())
    return {};
  std::vector<double> e = distanceToSegments(s, segmentsOf(s, inner), kFar);
  for (std::size_t v = 0; v < e.size(); ++v)
    e[v] = (depth[v] >= level + kInwards ? e[v] : -e[v]) / hatchMm[v];
  std::vector<SurfaceCurve> curves = isolines(s, e, -kInwards);
  std::erase_if(curves, [](const SurfaceCurve& c) { return lengthOf(c) < kShortest; });
  return curves;
}

} // namespace voluta::toolpath
