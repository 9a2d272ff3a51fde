#include "toolpath/infill/nested_loops.h"

#include "base/index.h"
#include "geometry/edges.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/infill/walls.h"

#include <algorithm>
#include <utility>

namespace voluta::toolpath {

namespace {
using base::at;

// [hatches], less than for walls: neighbours of the innermost loop move outwards, so that its two
// sides get room, and there is no other bead between them. Nearer to each other, the sides would
// cross.
constexpr double kInwards = 0.2;

// [hatches]: shorter loops within another are left out; it closes their place, and they would be
// cut over most of their length to be joined.
constexpr double kShortest = 5.0;

// Returns a vertex of the given rank beside the curve after uniting all such vertices; -1 if there
// is none.
int uniteBeside(const PatchSurface& s, const SurfaceCurve& curve, const std::vector<int>& rank,
                int wanted, geometry::UnionFind& bands) {
  int beside = -1;
  for (const SurfacePoint& p : curve.points)
    for (const int v : s.triangles[at(p.triangle)]) {
      if (rank[at(v)] != wanted)
        continue;
      if (beside >= 0)
        bands.join(v, beside);
      beside = v;
    }
  return beside;
}
} // namespace

NestedLoops nestedLoops(const InfillRegion& r, const base::RunContext& ctx) {
  const PatchSurface& s = r.surface;
  const double deepest = *std::ranges::max_element(r.depth);
  NestedLoops nested;
  std::vector<int>& rank = nested.rank;
  rank.assign(s.position.size(), 0);
  std::vector<int> rankOfLoop; // Of the vertices inside
  int number = 0;
  for (double level = r.from + 0.5; level < deepest; level += 1.0) {
    ctx.checkpoint();
    const LevelSet inside = openedAt(s, r.depth, r.hatchMm, r.beadScale, level, kInwards);
    ++number;
    for (std::size_t v = 0; v < inside.value.size(); ++v)
      if (inside.value[v] >= inside.level)
        rank[v] = number;
    for (SurfaceCurve& c : wallsAround(s, inside, r.beadScale)) {
      if (number > 1 && lengthOf(c) < kShortest * s.interpolate(r.hatchMm, c.points.front()))
        continue;
      if (!c.closed) {
        nested.open.push_back(std::move(c));
      } else {
        nested.loops.push_back({std::move(c)});
        rankOfLoop.push_back(number);
      }
    }
  }
  geometry::UnionFind bands(rank.size());
  for (const auto& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (const int a = t[k], b = t[(k + 1) % 3]; rank[at(a)] == rank[at(b)])
        bands.join(a, b);
  for (std::size_t i = 0; i < nested.loops.size(); ++i)
    for (const int side : {0, 1})
      if (const int wanted = rankOfLoop[i] - 1 + side; wanted > 0)
        nested.loops[i].band[at(side)] = uniteBeside(s, nested.loops[i].curve, rank, wanted, bands);
  std::vector<int> numberOf(rank.size(), -1);
  for (std::size_t i = 0; i < nested.loops.size(); ++i)
    for (int& band : nested.loops[i].band) {
      if (band == kNoBand)
        continue;
      int& known = numberOf[at(bands.find(band))];
      if (known < 0) {
        known = static_cast<int>(nested.ofBand.size());
        nested.ofBand.emplace_back();
      }
      band = known;
      nested.ofBand[at(band)].push_back(static_cast<int>(i));
    }
  return nested;
}

} // namespace voluta::toolpath
