#include "toolpath/infill/gap_fill.h"

#include "base/index.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/infill/regions.h"
#include "toolpath/surface_fields.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace voluta::toolpath {

namespace {
using base::at;

constexpr double kEdge = 0.18;       // [hatches]: distance between the ends of spine and gap
constexpr double kWorthwhile = 0.28; // [hatches]: half width of the narrowest gap that gets a bead
constexpr int kRounds = 8;           // Branches of branches
// [mm], for beads of 1.2 mm (bead_scale.h): resampling step, and the minimum length of the spines
// of wide and narrow gaps.
constexpr double kStep = 0.4, kShortestWide = 0.5, kShortestNarrow = 1.2;

// Shortest paths from one vertex within a region, with lengths weighted by the vertices' cost.
class Ways {
public:
  Ways(const PatchSurface& s, const Regions& regions, const std::vector<double>& cost)
      : s_(s), regions_(regions), cost_(cost), length_(s.position.size(), INFINITY),
        parent_(s.position.size(), -1) {}

  // Returns the reachable vertex that is farthest from `start`.
  int furthest(int start, bool weighted) {
    for (const int v : touched_)
      length_[at(v)] = INFINITY;
    touched_ = {start};
    length_[at(start)] = 0;
    parent_[at(start)] = -1;
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.emplace(0.0, start);
    int last = start;
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > length_[at(v)])
        continue;
      last = v;
      for (const int* t = s_.ringBegin(v); t != s_.ringEnd(v); ++t)
        for (const int w : s_.triangles[at(*t)]) {
          if (w == v || regions_.ofVertex[at(w)] != regions_.ofVertex[at(start)])
            continue;
          double step = (s_.position[at(w)] - s_.position[at(v)]).norm();
          if (weighted)
            step *= 0.5 * (cost_[at(v)] + cost_[at(w)]);
          if (d + step < length_[at(w)]) {
            if (!std::isfinite(length_[at(w)]))
              touched_.push_back(w);
            length_[at(w)] = d + step;
            parent_[at(w)] = v;
            queue.emplace(d + step, w);
          }
        }
    }
    return last;
  }
  std::vector<int> wayTo(int v) const {
    std::vector<int> way;
    for (; v >= 0; v = parent_[at(v)])
      way.push_back(v);
    return way;
  }

private:
  const PatchSurface& s_;
  const Regions& regions_;
  const std::vector<double>& cost_;
  std::vector<double> length_;
  std::vector<int> parent_, touched_;
};
} // namespace

std::vector<SurfaceCurve> gapSpines(const PatchSurface& s, const std::vector<double>& outsideMm,
                                    const std::vector<double>& boundaryMm,
                                    const std::vector<double>& hatchMm, double beadScale) {
  const std::size_t n = s.position.size();
  // Half of the available gap width at a vertex [hatches].
  std::vector<double> room(n);
  for (std::size_t v = 0; v < n; ++v)
    room[v] = std::min(boundaryMm[v], outsideMm[v]) / hatchMm[v];

  std::vector<SurfaceCurve> spines;
  std::vector<double> cost(n);
  for (int round = 0; round < kRounds; ++round) {
    const Regions regions = regionsAbove(s, room, kEdge);
    std::vector<int> widest(at(regions.count), -1);
    for (std::size_t v = 0; v < n; ++v) {
      const int r = regions.ofVertex[v];
      if (r >= 0 && (widest[at(r)] < 0 || room[v] > room[at(widest[at(r)])]))
        widest[at(r)] = static_cast<int>(v);
    }
    for (std::size_t v = 0; v < n; ++v) {
      const double r = std::max(0.05, room[v]);
      cost[v] = 1 / (r * r * r);
    }
    Ways ways(s, regions, cost);
    std::vector<SurfaceCurve> fresh;
    for (int r = 0; r < regions.count; ++r) {
      const int middle = widest[at(r)];
      const double half = room[at(middle)];
      if (half < kWorthwhile)
        continue;
      const int a = ways.furthest(middle, false);
      const int b = ways.furthest(a, false);
      ways.furthest(a, true);
      SurfaceCurve c;
      for (const int v : ways.wayTo(b))
        c.points.push_back({s.position[at(v)], *s.ringBegin(v)});
      const double shortest = beadScale * (half > 0.4 ? kShortestWide : kShortestNarrow);
      if (c.points.size() < 2 || lengthOf(c) < shortest)
        continue;
      ResampleOptions o;
      o.stepMm = kStep * beadScale;
      o.chordMm = INFINITY;
      o.cornerRad = 10.0; // A path along edges consists of corners
      Resampled even = resample(s, c, o);
      smoothCurve(s, even.curve, std::vector<char>(even.curve.points.size(), 0), 6);
      fresh.push_back(std::move(even.curve));
    }
    if (fresh.empty())
      break;
    // A spine's bead fills the gap around it up to the maximum bead width.
    const std::vector<double> toSpine =
        distanceToSegments(s, segmentsOf(s, fresh), kGapReachMm * beadScale);
    for (std::size_t v = 0; v < n; ++v)
      room[v] = std::min(room[v], (toSpine[v] - 0.8 * hatchMm[v]) / hatchMm[v]);
    for (SurfaceCurve& c : fresh)
      spines.push_back(std::move(c));
  }
  return spines;
}

} // namespace voluta::toolpath
