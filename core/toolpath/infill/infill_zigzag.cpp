#include "toolpath/coverage/line_cover.h"
#include "toolpath/infill/across_lines.h"
#include "toolpath/infill/infill.h"

#include <algorithm>
#include <iterator>

namespace voluta::toolpath {

namespace {
// [hatches] from the region's edge: deeper lines have neighbours on both sides, and the beads that
// join line ends are farther away.
constexpr double kEvenDepth = 1.5;

} // namespace

InfillLines zigzagInfill(const InfillRegion& region, const base::RunContext& ctx) {
  if (std::ranges::none_of(region.depth, [&](double d) { return d >= region.from; }))
    return {};
  const std::vector<double> across = acrossLines(region.surface, region.directionRad);
  InfillLines lines;
  if (region.surface.planeNormal)
    lines.uniformSpacingMm.assign(region.depth.size(), 0.0);
  forEachPart(region, ctx, [&](const std::vector<double>& depth, double deepest) {
    EvenLines more = deepest < kNarrowPart
                         ? EvenLines{concentricInfill(partOf(region, depth), ctx).curves}
                         : evenLines(region, depth, across, ctx);
    std::ranges::move(more.curves, std::back_inserter(lines.curves));
    for (std::size_t v = 0; v < lines.uniformSpacingMm.size(); ++v)
      if (depth[v] >= region.from + kEvenDepth)
        lines.uniformSpacingMm[v] = more.spacingMm;
  });
  return lines;
}

} // namespace voluta::toolpath
