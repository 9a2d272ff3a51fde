#include "base/index.h"
#include "toolpath/infill/infill.h"
#include "toolpath/infill/joined_loops.h"
#include "toolpath/infill/nested_loops.h"
#include "toolpath/surface_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::toolpath {

namespace {
using base::at;

constexpr double kFarthest = 3.2; // [hatches] between loops that are joined

// Joins the loops of each connected region to one closed curve.
class Joiner {
public:
  Joiner(const InfillRegion& r, const NestedLoops& nested, const base::RunContext& ctx)
      : r_(r), nested_(nested), ctx_(ctx), used_(nested.loops.size(), 0) {
    for (std::size_t i = 0; i < nested.loops.size(); ++i) {
      even_.push_back(evenLoop(r.surface, nested.loops[i].curve, static_cast<int>(i), hatch(i)));
      extent_.emplace_back();
      for (const SurfacePoint& p : even_.back().points)
        extent_.back().extend(p.position);
    }
  }

  std::vector<SurfaceCurve> curves() {
    std::vector<SurfaceCurve> all;
    for (std::size_t i = 0; i < used_.size(); ++i) {
      if (used_[i])
        continue;
      JoinedLoops whole = chainFrom(static_cast<int>(i), 1);
      while (!branches_.empty()) {
        const int band = branches_.back();
        branches_.pop_back();
        joinBranch(whole, nested_.ofBand[at(band)], band);
      }
      all.push_back({std::move(whole.points), true});
    }
    all.insert(all.end(), apart_.begin(), apart_.end());
    return all;
  }

private:
  double hatch(std::size_t loop) const {
    return r_.surface.interpolate(r_.hatchMm, nested_.loops[loop].curve.points.front());
  }

  // Returns whether the loop is the part's surface. A spiral would leave a wedge open there.
  bool isSurface(int loop) const {
    return r_.from < 0.5 && nested_.loops[at(loop)].band[0] == kNoBand;
  }

  // Returns the double spiral of the loops from `first` to the next branch, beginning on one side
  // of it (0: outer, 1: inner). Remembers the branch.
  JoinedLoops chainFrom(int first, int side) {
    std::vector<JoinedLoops> chain;
    bool isReversed = false;
    for (int loop = first;;) {
      used_[at(loop)] = 1;
      chain.push_back(even_[at(loop)]);
      if (isReversed)
        std::ranges::reverse(chain.back().points);
      const int band = nested_.loops[at(loop)].band[at(side)];
      if (band == kNoBand)
        break;
      const std::vector<int>& around = nested_.ofBand[at(band)];
      if (around.size() > 2 || std::ranges::any_of(around, [&](int l) { return isSurface(l); })) {
        branches_.push_back(band);
        break;
      }
      const int next = around.front() == loop ? around.back() : around.front();
      if (used_[at(next)])
        break;
      // A loop that is entered from its inner side runs the other way around.
      const int entered = nested_.loops[at(next)].band[0] == band ? 0 : 1;
      if (entered == side)
        isReversed = !isReversed;
      side = 1 - entered;
      loop = next;
    }
    return doubleSpiral(r_.surface, chain, hatch(at(first)));
  }

  bool areNear(int a, int b) const {
    return extent_[at(a)].exteriorDistance(extent_[at(b)]) < kFarthest * hatch(at(b));
  }

  // Joins the band's remaining loops, with the chains behind them, each where it is beside a loop
  // that is joined already.
  void joinBranch(JoinedLoops& whole, const std::vector<int>& loops, int band) {
    std::vector<double> cost(loops.size(), INFINITY);
    const auto offer = [&](int joined) {
      for (std::size_t i = 0; i < loops.size(); ++i)
        if (const int loop = loops[i]; !used_[at(loop)] && areNear(joined, loop))
          cost[i] = std::min(cost[i], bestAdjacency(even_[at(joined)], {joined}, even_[at(loop)],
                                                    loop, kFarthest, hatch(at(loop)))
                                          .cost);
    };
    for (const int loop : loops)
      if (used_[at(loop)])
        offer(loop);
    for (;;) {
      ctx_.checkpoint();
      std::size_t best = 0;
      for (std::size_t i = 0; i < loops.size(); ++i) {
        cost[i] = used_[at(loops[i])] ? INFINITY : cost[i];
        best = cost[i] < cost[best] ? i : best;
      }
      if (cost[best] == INFINITY)
        return;
      const int loop = loops[best];
      std::vector<int> beside;
      for (const int other : loops)
        if (used_[at(other)] && areNear(other, loop))
          beside.push_back(other);
      const int onwards = nested_.loops[at(loop)].band[0] == band ? 1 : 0;
      const JoinedLoops more = chainFrom(loop, onwards);
      const Adjacency place = bestAdjacency(whole, beside, more, loop, kFarthest, hatch(at(loop)));
      if (place.a >= 0)
        join(whole, more, place, hatch(at(loop)));
      else
        apart_.push_back({more.points, true});
      offer(loop);
    }
  }

  const InfillRegion& r_;
  const NestedLoops& nested_;
  const base::RunContext& ctx_;
  std::vector<char> used_;
  std::vector<JoinedLoops> even_;           // Per loop
  std::vector<Eigen::AlignedBox3d> extent_; // Per loop
  std::vector<int> branches_;               // Bands whose loops are not all joined
  std::vector<SurfaceCurve> apart_; // Chains whose neighbours have no place left beside them
};

// Returns per vertex whether the loops fill its surroundings: inside and just outside of them.
std::vector<char> filledBy(const InfillRegion& r, const NestedLoops& nested) {
  constexpr double kBeyond = 0.6; // [hatches] outside the outermost loops
  std::vector<SurfaceCurve> outermost;
  for (const NestedLoop& loop : nested.loops)
    if (loop.band[0] == kNoBand)
      outermost.push_back(loop.curve);
  const double widest = *std::ranges::max_element(r.hatchMm);
  const std::vector<double> off =
      distanceToSegments(r.surface, segmentsOf(r.surface, outermost), widest);
  std::vector<char> isFilled(off.size());
  for (std::size_t v = 0; v < off.size(); ++v)
    isFilled[v] = nested.rank[v] > 0 || off[v] < kBeyond * r.hatchMm[v];
  return isFilled;
}
} // namespace

InfillLines fermatInfill(const InfillRegion& r, const base::RunContext& ctx) {
  const NestedLoops nested = nestedLoops(r, ctx);
  InfillLines lines{Joiner(r, nested, ctx).curves()};
  lines.isClosed = filledBy(r, nested);
  lines.curves.insert(lines.curves.end(), nested.open.begin(), nested.open.end());
  return lines;
}

} // namespace voluta::toolpath
