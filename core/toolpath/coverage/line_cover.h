// Cuts infill lines to a region and joins them end to end.
#pragma once

#include "toolpath/infill/infill.h"
#include "toolpath/infill/regions.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace voluta::toolpath {

// [hatches]: parts of a region that are nowhere deeper are filled along their edge.
inline constexpr double kNarrowPart = 4.2;

// Calls part(depth, deepest) for each connected part of a region: `depth` is set to outside in the
// other parts, `deepest` is the maximum depth from the region's edge [hatches].
template <typename F>
void forEachPart(const InfillRegion& r, const base::RunContext& ctx, F&& part) {
  const Regions regions = regionsAbove(r.surface, r.depth, r.from);
  std::vector<double> deepest(static_cast<std::size_t>(regions.count), 0.0);
  for (std::size_t v = 0; v < r.depth.size(); ++v)
    if (regions.ofVertex[v] >= 0) {
      double& d = deepest[static_cast<std::size_t>(regions.ofVertex[v])];
      d = std::max(d, r.depth[v]);
    }
  for (int i = 0; i < regions.count; ++i) {
    ctx.checkpoint();
    std::vector<double> own = r.depth;
    for (std::size_t v = 0; v < own.size(); ++v)
      if (regions.ofVertex[v] != i && own[v] >= r.from)
        own[v] = r.from - 1;
    part(own, deepest[static_cast<std::size_t>(i)] - r.from);
  }
}

// Returns the same infill restricted to one part of its region.
inline InfillRegion partOf(const InfillRegion& r, const std::vector<double>& depth) {
  return {r.surface,      depth,        r.hatchMm,   r.from,   r.layer,
          r.directionRad, r.windingRad, r.beadScale, r.strands};
}

class LineCover {
public:
  // `depth`: of one part of the region. Region and depth must outlive this object.
  LineCover(const InfillRegion& region, const std::vector<double>& depth)
      : r_(region), s_(region.surface), depth_(depth) {}

  // Keeps the sections of a line that are in the part. Lines of consecutive levels are neighbours.
  void add(const SurfaceCurve& line, int level);
  // Returns the lines, joined by beads along the part's edge where there is room for them: those of
  // neighbouring levels first, then the ends of the resulting chains.
  std::vector<SurfaceCurve> joined(double spacingMm, const base::RunContext& ctx);

private:
  struct Line {
    std::vector<SurfacePoint> points;
    std::vector<double> depth; // Per point
    int level = 0;
    bool closed = false, used = false;
  };

  std::size_t deepFrom(const Line& line, bool fromBack) const;
  std::vector<SurfacePoint> bridge(const SurfacePoint& from, const SurfacePoint& to) const;
  std::optional<SurfacePoint> joint(const Line& line, bool back) const;
  void append(Line& line, Line next) const;
  static void reverse(Line& line);
  std::vector<Line> chains(double farthestMm, const base::RunContext& ctx);
  void joinChains(std::vector<Line>& chains, double farthestMm, const base::RunContext& ctx) const;

  const InfillRegion& r_;
  const PatchSurface& s_;
  const std::vector<double>& depth_;
  std::vector<Line> lines_;
};

struct EvenLines {
  std::vector<SurfaceCurve> curves;
  double spacingMm = 0.0; // Between neighbours, measured by `across`; 0: no even lines
};
// Returns isolines of `across` (per vertex, [mm]; finite in the part) over one part of a region,
// evenly spaced from its minimum to its maximum.
EvenLines evenLines(const InfillRegion& region, const std::vector<double>& depth,
                    const std::vector<double>& across, const base::RunContext& ctx);

} // namespace voluta::toolpath
