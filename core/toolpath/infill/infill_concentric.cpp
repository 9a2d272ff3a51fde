#include "toolpath/infill/infill.h"
#include "toolpath/infill/walls.h"

#include <algorithm>

namespace voluta::toolpath {

InfillLines concentricInfill(const InfillRegion& r, const base::RunContext& ctx) {
  std::vector<SurfaceCurve> curves;
  const double deepest = *std::ranges::max_element(r.depth);
  for (double level = r.from + 0.5; level < deepest; level += 1.0) {
    ctx.checkpoint();
    for (SurfaceCurve& c : wallAt(r.surface, r.depth, r.hatchMm, r.beadScale, level))
      curves.push_back(std::move(c));
  }
  return {std::move(curves)};
}

} // namespace voluta::toolpath
