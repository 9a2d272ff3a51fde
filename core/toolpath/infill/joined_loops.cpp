#include "toolpath/infill/joined_loops.h"

#include "base/error.h"
#include "base/index.h"
#include "geometry/polyline.h"
#include "toolpath/infill/curve_tools.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::toolpath {

namespace {
using base::at;
using Eigen::Vector3d;

constexpr double kStep = 0.25; // [hatches]: distance of the points of even loops
// [hatches]: length over which a spiral changes loops. The way to or from the first and last two
// leaves a wedge open, small if it is steep; two loops have their ends joined side by side, a hatch
// apart.
constexpr double kWindow = 6.0, kEndWindow = 2.5;
constexpr double kMaxWindowShare = 0.4; // The same as a share of the loop's length
constexpr int kPlaces = 48;             // Places tried for that stretch
constexpr double kBeside = 1.25; // [hatches] both ways: curves are to be straight where joined
constexpr double kBentCost = 4.0;

// A closed curve of evenly spaced points.
class Ring {
public:
  Ring(const PatchSurface& s, const JoinedLoops& loop) : s_(s), points_(loop.points) {
    length_ = geometry::polylineLength(
        points_.size() + 1, [&](std::size_t i) { return points_[i % points_.size()].position; });
    step_ = length_ / static_cast<double>(points_.size());
  }
  double lengthMm() const { return length_; }
  // Returns the point at an arc length from the first point, any number of turns.
  SurfacePoint pointAt(double mm) const {
    const double turns = mm / length_, index = (turns - std::floor(turns)) * count();
    const auto i = std::min(static_cast<std::size_t>(index), points_.size() - 1);
    const double t = index - static_cast<double>(i);
    const SurfacePoint &a = points_[i], &b = points_[(i + 1) % points_.size()];
    return {(1 - t) * a.position + t * b.position, a.triangle};
  }
  // Returns the arc length of the point nearest to `p`.
  double nearest(const Vector3d& p) const {
    const auto it = std::ranges::min_element(
        points_, {}, [&](const SurfacePoint& q) { return (q.position - p).squaredNorm(); });
    return static_cast<double>(it - points_.begin()) * step_;
  }
  // Returns the points from one arc length to a larger one, both ends included.
  void append(double from, double to, int loop, JoinedLoops& out) const {
    const auto add = [&](const SurfacePoint& p) {
      out.points.push_back(s_.project(p.position, p.triangle));
      out.loop.push_back(loop);
    };
    const int steps = std::max(1, static_cast<int>(std::lround((to - from) / step_)));
    for (int k = 0; k <= steps; ++k)
      add(pointAt(from + (to - from) * k / steps));
  }

private:
  double count() const { return static_cast<double>(points_.size()); }

  const PatchSurface& s_;
  const std::vector<SurfacePoint>& points_;
  double length_ = 0.0, step_ = 0.0;
};

// 0 on a straight stretch, 1 where a curve returns to where it came from.
double bend(const Vector3d& before, const Vector3d& here, const Vector3d& after) {
  const double along = (here - before).norm() + (after - here).norm();
  return along > 0.0 ? 1.0 - (after - before).norm() / along : 0.0;
}

class Spiral {
public:
  Spiral(const PatchSurface& s, const std::vector<JoinedLoops>& chain, double hatchMm)
      : s_(s), chain_(chain), hatch_(hatchMm) {
    for (const JoinedLoops& loop : chain)
      rings_.emplace_back(s, loop);
    const std::size_t n = chain.size();
    for (std::size_t i = 0; i < n; ++i) {
      const double maximum = n == 2 ? 1.0 : i < 2 || i + 2 >= n ? kEndWindow : kWindow;
      window_.push_back(std::min(maximum * hatchMm, kMaxWindowShare * rings_[i].lengthMm()));
    }
    place();
  }

  JoinedLoops curve() const {
    JoinedLoops out;
    const std::size_t n = rings_.size(), lastEven = (n - 1) / 2 * 2;
    for (std::size_t i = 0; i < n; i += 2) {
      around(i, out);
      if (i < lastEven)
        change(i, out);
    }
    JoinedLoops outwards;
    for (std::size_t i = 1; i < n; i += 2) {
      around(i, outwards);
      if (i + 2 < n)
        change(i, outwards);
    }
    out.points.insert(out.points.end(), outwards.points.rbegin(), outwards.points.rend());
    out.loop.insert(out.loop.end(), outwards.loop.rbegin(), outwards.loop.rend());
    return out;
  }

private:
  // Chooses the middles of the windows.
  void place() {
    const std::size_t n = rings_.size();
    const auto byLength = [](const Ring& r) { return r.lengthMm(); };
    const auto shortest =
        static_cast<std::size_t>(std::ranges::min_element(rings_, {}, byLength) - rings_.begin());
    const double length = rings_[shortest].lengthMm();
    const int places = std::clamp(static_cast<int>(length / hatch_), 4, kPlaces);
    double minimum = INFINITY;
    for (int k = 0; k < places; ++k) {
      std::vector<double> middle(n);
      middle[shortest] = length * k / places;
      double cost = bendAt(shortest, middle[shortest]);
      const auto next = [&](std::size_t from, std::size_t to) {
        const Vector3d p = rings_[from].pointAt(middle[from]).position;
        middle[to] = rings_[to].nearest(p);
        const double gap = (rings_[to].pointAt(middle[to]).position - p).norm();
        cost += bendAt(to, middle[to]) + std::abs(gap / hatch_ - 1.0);
      };
      for (std::size_t i = shortest; i-- > 0;)
        next(i + 1, i);
      for (std::size_t i = shortest + 1; i < n; ++i)
        next(i - 1, i);
      if (cost < minimum) {
        minimum = cost;
        middle_ = std::move(middle);
      }
    }
  }
  double bendAt(std::size_t i, double middle) const {
    const double half = 0.75 * window_[i];
    return kBentCost * bend(rings_[i].pointAt(middle - half).position,
                            rings_[i].pointAt(middle).position,
                            rings_[i].pointAt(middle + half).position);
  }

  // Appends a loop from the end of its window to its beginning.
  void around(std::size_t i, JoinedLoops& out) const {
    const double half = 0.5 * window_[i];
    rings_[i].append(middle_[i] + half, middle_[i] + rings_[i].lengthMm() - half,
                     chain_[i].loop.front(), out);
  }
  // Appends the way from a loop to the one after the next, without its ends.
  void change(std::size_t i, JoinedLoops& out) const {
    const int steps = std::max(3, static_cast<int>(window_[i] / (kStep * hatch_)));
    for (int k = 1; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const SurfacePoint a = rings_[i].pointAt(middle_[i] + (t - 0.5) * window_[i]),
                         b = rings_[i + 2].pointAt(middle_[i + 2] + (t - 0.5) * window_[i + 2]);
      out.points.push_back(
          s_.project((1 - t) * a.position + t * b.position, t < 0.5 ? a.triangle : b.triangle));
      out.loop.push_back(-1);
    }
  }

  const PatchSurface& s_;
  const std::vector<JoinedLoops>& chain_;
  double hatch_;
  std::vector<Ring> rings_;
  std::vector<double> window_, middle_; // Per loop [mm]
};

// Returns the index reached `mm` from a point along the curve, forwards or backwards.
std::size_t walk(const JoinedLoops& c, std::size_t from, double mm, bool forwards) {
  const std::size_t n = c.points.size();
  std::size_t i = from;
  for (std::size_t steps = 0; steps < n && mm > 0.0; ++steps) {
    const std::size_t next = (i + (forwards ? 1 : n - 1)) % n;
    const double length = (c.points[next].position - c.points[i].position).norm();
    if (mm < 0.5 * length)
      break;
    mm -= length;
    i = next;
  }
  return i;
}

// Returns the bend of a curve at a point; 1 if a loop ends near it.
double bendNear(const JoinedLoops& c, std::size_t i, double reachMm) {
  const std::size_t before = walk(c, i, reachMm, false), after = walk(c, i, reachMm, true);
  if (c.loop[before] != c.loop[i] || c.loop[after] != c.loop[i])
    return 1.0;
  return bend(c.points[before].position, c.points[i].position, c.points[after].position);
}

// Returns the curve without half a hatch to either side of a point, from the end of the gap to its
// beginning.
JoinedLoops opened(const JoinedLoops& c, int place, double hatchMm) {
  const std::size_t n = c.points.size(), from = walk(c, at(place), 0.5 * hatchMm, true),
                    to = walk(c, at(place), 0.5 * hatchMm, false);
  JoinedLoops out;
  for (std::size_t k = 0; k <= (to + n - from) % n; ++k) {
    out.points.push_back(c.points[(from + k) % n]);
    out.loop.push_back(c.loop[(from + k) % n]);
  }
  return out;
}
} // namespace

JoinedLoops evenLoop(const PatchSurface& s, const SurfaceCurve& loop, int number, double hatchMm) {
  ResampleOptions even;
  even.stepMm = kStep * hatchMm;
  even.chordMm = INFINITY;
  even.cornerRad = 10.0;
  JoinedLoops out{resample(s, loop, even).curve.points, {}};
  out.loop.assign(out.points.size(), number);
  return out;
}

JoinedLoops doubleSpiral(const PatchSurface& s, const std::vector<JoinedLoops>& chain,
                         double hatchMm) {
  base::require(!chain.empty(), "doubleSpiral: a loop");
  return chain.size() == 1 ? chain.front() : Spiral(s, chain, hatchMm).curve();
}

Adjacency bestAdjacency(const JoinedLoops& a, const std::vector<int>& loopsOfA,
                        const JoinedLoops& b, int loopOfB, double farthest, double hatchMm) {
  Adjacency best;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    if (a.loop[i] < 0 || std::ranges::find(loopsOfA, a.loop[i]) == loopsOfA.end())
      continue;
    std::size_t nearest = 0;
    double squared = farthest * farthest * hatchMm * hatchMm;
    bool found = false;
    for (std::size_t k = 0; k < b.points.size(); ++k) {
      if (b.loop[k] != loopOfB)
        continue;
      const double d = (b.points[k].position - a.points[i].position).squaredNorm();
      if (d < squared) {
        squared = d;
        nearest = k;
        found = true;
      }
    }
    if (!found)
      continue;
    double cost = std::abs(std::sqrt(squared) / hatchMm - 1.0);
    if (cost >= best.cost)
      continue;
    cost += kBentCost * bendNear(a, i, kBeside * hatchMm);
    if (cost >= best.cost)
      continue;
    cost += kBentCost * bendNear(b, nearest, kBeside * hatchMm);
    if (cost < best.cost)
      best = {static_cast<int>(i), static_cast<int>(nearest), cost};
  }
  return best;
}

void join(JoinedLoops& a, const JoinedLoops& b, const Adjacency& place, double hatchMm) {
  JoinedLoops whole = opened(a, place.a, hatchMm), more = opened(b, place.b, hatchMm);
  const Vector3d &end = whole.points.back().position, &start = whole.points.front().position,
                 &first = more.points.front().position, &last = more.points.back().position;
  if ((first - end).norm() + (last - start).norm() > (last - end).norm() + (first - start).norm()) {
    std::ranges::reverse(more.points);
    std::ranges::reverse(more.loop);
  }
  whole.points.insert(whole.points.end(), more.points.begin(), more.points.end());
  whole.loop.insert(whole.loop.end(), more.loop.begin(), more.loop.end());
  a = std::move(whole);
}

} // namespace voluta::toolpath
