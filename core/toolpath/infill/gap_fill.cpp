#include "toolpath/infill/gap_fill.h"

#include "base/index.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/infill/regions.h"
#include "toolpath/infill/ring_spines.h"
#include "toolpath/surface_fields.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace voluta::toolpath {

namespace {
using base::at;

constexpr double kEdge = 0.18; // [hatches]: distance between the ends of spine and gap
// [hatches]: vertices between beads with this room are joined to one gap. Beside the middle of a
// narrow gap few have more.
constexpr double kLinked = 0.08;
constexpr double kWorthwhile = 0.28; // [hatches]: half width of the narrowest gap that gets a bead
// [hatches]: greatest distance between the ends of two spines of one ring. The second begins 0.8
// hatches and an edge beyond the end of the first.
constexpr double kRingGap = 1.3;
constexpr int kRounds = 8; // Branches of branches
// Near its ends a spine keeps to vertices with this share of the room [hatches] nearby.
constexpr double kMiddle = 0.85, kCornerReach = 1.2;
// [mm], for beads of 1.2 mm (bead_scale.h): resampling step, and the minimum length of the spines
// of wide and narrow gaps.
constexpr double kStep = 0.4, kShortestWide = 0.5, kShortestNarrow = 1.2;

// Shortest paths from one vertex within a region, with lengths weighted by the vertices' cost.
class Ways {
public:
  Ways(const PatchSurface& s, const Regions& regions, const std::vector<double>& room,
       const std::vector<double>& cost)
      : s_(s), regions_(regions), room_(room), cost_(cost), length_(s.position.size(), INFINITY),
        parent_(s.position.size(), -1) {}

  // Returns the reachable vertex with room for a bead that is farthest from `start`.
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
      if (room_[at(v)] >= kEdge)
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
  std::vector<int> pathTo(int v) const {
    std::vector<int> path;
    for (; v >= 0; v = parent_[at(v)])
      path.push_back(v);
    return path;
  }

private:
  const PatchSurface& s_;
  const Regions& regions_;
  const std::vector<double>& room_;
  const std::vector<double>& cost_;
  std::vector<double> length_;
  std::vector<int> parent_, touched_;
};

// Removes the ends of a way that leave the middle of the gap: the vertex that is farthest away is
// in a corner of it.
void dropCorners(const PatchSurface& s, const std::vector<double>& room, double reachMm,
                 std::vector<int>& path) {
  for (int end = 0; end < 2; ++end) {
    double length = 0.0, widest = 0.0;
    std::size_t reach = 0;
    for (; reach < path.size() && length < reachMm; ++reach) {
      widest = std::max(widest, room[at(path[reach])]);
      if (reach > 0)
        length += (s.position[at(path[reach])] - s.position[at(path[reach - 1])]).norm();
    }
    std::size_t first = 0;
    while (first < reach && room[at(path[first])] < kMiddle * widest)
      ++first;
    if (path.size() - first >= 2)
      path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(first));
    std::ranges::reverse(path);
  }
}

// Returns the place on a line across a curve, up to `reachMm` to either side of `middle`, where
// `width` (per vertex) is largest; `otherwise` if it is nowhere larger than `atLeast`.
SurfacePoint widestAcross(const PatchSurface& s, const std::vector<double>& width,
                          const Eigen::Vector3d& middle, const Eigen::Vector3d& along,
                          double reachMm, int sides, double atLeast, SurfacePoint otherwise) {
  const Eigen::Vector3d left = s.interpolate(s.normal, otherwise).cross(along).normalized();
  SurfacePoint widest = otherwise;
  for (int k = -sides; k <= sides; ++k) {
    const SurfacePoint q = s.project(middle + reachMm * k / sides * left, otherwise.triangle);
    if (const double w = s.interpolate(width, q); w > atLeast) {
      atLeast = w;
      widest = q;
    }
  }
  return widest;
}

// Moves each point across the curve to where the gap is widest, up to `reachMm` away.
void moveToRidge(const PatchSurface& s, const std::vector<double>& room, double reachMm,
                 SurfaceCurve& c) {
  constexpr int kSides = 6;
  const std::vector<SurfacePoint> old = c.points;
  for (std::size_t i = 0; i < old.size(); ++i) {
    const Eigen::Vector3d along =
        old[std::min(i + 1, old.size() - 1)].position - old[i == 0 ? 0 : i - 1].position;
    c.points[i] = widestAcross(s, room, old[i].position, along, reachMm, kSides,
                               s.interpolate(room, old[i]) + 1e-6, old[i]);
  }
}

// Continues a curve beyond both ends as far as the gap has room: along the middle between the
// boundaries, and straight on where that middle ends.
void extendEnds(const PatchSurface& s, const std::vector<double>& room,
                const std::vector<double>& boundaryMm, double hatchMm, SurfaceCurve& c) {
  constexpr double kStepShare = 0.25,
                   kRotationShare = 0.3; // [hatches]; weight of the newest direction
  constexpr int kSteps = 12, kSides = 3;
  const double step = kStepShare * hatchMm;
  for (int end = 0; end < 2; ++end) {
    std::ranges::reverse(c.points);
    std::size_t from = c.points.size() - 1;
    while (from > 0 && (c.points[from].position - c.points.back().position).norm() < hatchMm)
      --from;
    Eigen::Vector3d along = (c.points.back().position - c.points[from].position).normalized();
    const double wide = kMiddle * s.interpolate(boundaryMm, c.points.back());
    for (int k = 0; k < kSteps; ++k) {
      const SurfacePoint last = c.points.back();
      const Eigen::Vector3d ahead = last.position + step * along;
      SurfacePoint next = s.project(ahead, last.triangle);
      if ((next.position - ahead).norm() > 0.5 * step)
        break;
      next = widestAcross(s, boundaryMm, ahead, along, step, kSides,
                          std::max(wide, s.interpolate(boundaryMm, next) + 1e-6), next);
      if (s.interpolate(room, next) < kEdge)
        break;
      along = (along + kRotationShare * ((next.position - last.position).normalized() - along))
                  .normalized();
      c.points.push_back(next);
    }
  }
}
} // namespace

std::vector<SurfaceCurve> gapSpines(const PatchSurface& s, const std::vector<double>& outsideMm,
                                    const std::vector<double>& boundaryMm,
                                    const std::vector<double>& hatchMm, double beadScale,
                                    double narrowest) {
  // Three beads of the narrowest width fill this gap between two usual ones.
  const double worthwhile = std::max(kWorthwhile, 1.5 * narrowest - 1.0);
  const std::size_t n = s.position.size();
  // Half of the available gap width at a vertex [hatches].
  std::vector<double> room(n);
  for (std::size_t v = 0; v < n; ++v)
    room[v] = std::min(boundaryMm[v], outsideMm[v]) / hatchMm[v];

  // In a wall and in the tip of a wedge, the boundary is as near as the bead.
  const auto isBetweenBeads = [&](std::size_t v) {
    return boundaryMm[v] > (room[v] + 0.5) * hatchMm[v];
  };
  const std::vector<double> wholeRoom = room;
  std::vector<SurfaceCurve> spines;
  std::vector<double> cost(n);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> linked = room;
    for (std::size_t v = 0; v < n; ++v)
      if (room[v] >= kLinked && isBetweenBeads(v))
        linked[v] = std::max(room[v], kEdge);
    const Regions regions = regionsAbove(s, linked, kEdge);
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
    Ways ways(s, regions, room, cost);
    std::vector<SurfaceCurve> fresh;
    for (int r = 0; r < regions.count; ++r) {
      const int middle = widest[at(r)];
      const double half = room[at(middle)];
      if (half < (isBetweenBeads(at(middle)) ? worthwhile : kWorthwhile))
        continue;
      const int a = ways.furthest(middle, false);
      const int b = ways.furthest(a, false);
      ways.furthest(a, true);
      std::vector<int> path = ways.pathTo(b);
      const double hatch = hatchMm[at(middle)];
      dropCorners(s, room, kCornerReach * hatch, path);
      SurfaceCurve c;
      for (const int v : path)
        c.points.push_back({s.position[at(v)], *s.ringBegin(v)});
      const double shortest = beadScale * (half > 0.4 ? kShortestWide : kShortestNarrow);
      if (c.points.size() < 2)
        continue;
      ResampleOptions o;
      o.stepMm = kStep * beadScale;
      o.chordMm = INFINITY;
      o.cornerRad = 10.0; // A path along edges consists of corners
      Resampled even = resample(s, c, o);
      smoothCurve(s, even.curve, std::vector<char>(even.curve.points.size(), 0), 6);
      for (int pass = 0; pass < 2; ++pass) {
        moveToRidge(s, room, 0.4 * hatch, even.curve);
        smoothCurve(s, even.curve, std::vector<char>(even.curve.points.size(), 0), 1);
      }
      extendEnds(s, room, boundaryMm, hatch, even.curve);
      if (lengthOf(even.curve) < shortest)
        continue;
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
  if (spines.empty())
    return spines;
  const double hatch = *std::ranges::max_element(hatchMm);
  return joinRings(s, std::move(spines), wholeRoom, kEdge, kRingGap * hatch);
}

} // namespace voluta::toolpath
