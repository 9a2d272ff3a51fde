#include "toolpath/coverage/line_cover.h"

#include "base/index.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/surface_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

using base::at;

constexpr double kOpenEnd = 0.08; // [hatches] from the region's edge to an unjoined end
// [hatches] from the region's edge to the bead that joins two lines
constexpr double kJoinedEnd = 0.45;
// [spacings] between the ends of joined lines: where lines run at a small angle to the edge, ends
// of neighbours are far apart along it
constexpr double kFarthestJoin = 8.0;
} // namespace

void LineCover::add(const SurfaceCurve& c, int level) {
  const double edge = r_.from + kOpenEnd;
  const std::size_t n = c.points.size();
  std::vector<double> d(n);
  for (std::size_t i = 0; i < n; ++i)
    d[i] = s_.interpolate(depth_, c.points[i]);
  const auto firstOutside = std::ranges::find_if(d, [&](double x) { return x < edge; });
  if (firstOutside == d.end()) {
    lines_.push_back({c.points, d, level, c.closed, false});
    return;
  }
  const std::size_t start = c.closed ? static_cast<std::size_t>(firstOutside - d.begin()) : 0;
  Line line;
  const auto finish = [&] {
    SurfaceCurve whole{line.points, false};
    if (line.points.size() >= 2 && lengthOf(whole) > 0.4) {
      line.level = level;
      lines_.push_back(line);
    }
    line = {};
  };
  const auto cross = [&](std::size_t i, std::size_t j) {
    const double t = (edge - d[i]) / (d[j] - d[i]);
    const Vector3d p = (1 - t) * c.points[i].position + t * c.points[j].position;
    line.points.push_back(s_.project(p, c.points[i].triangle));
    line.depth.push_back(edge);
  };
  for (std::size_t k = 0; k < n + (c.closed ? 1 : 0); ++k) {
    const std::size_t i = (start + k) % n, before = (start + k + n - 1) % n;
    const bool first = k == 0;
    if (!first && (d[before] >= edge) != (d[i] >= edge)) {
      cross(before, i);
      if (d[i] < edge)
        finish();
    }
    if (d[i] >= edge) {
      line.points.push_back(c.points[i]);
      line.depth.push_back(d[i]);
    }
  }
  finish();
}

// Returns the index from which a line, walked from its end, is deep enough for the joining bead;
// the line's size if it never is.
std::size_t LineCover::deepFrom(const Line& line, bool fromBack) const {
  const std::size_t n = line.points.size();
  for (std::size_t i = 0; i < n; ++i)
    if (line.depth[fromBack ? n - 1 - i : i] >= r_.from + kJoinedEnd)
      return i;
  return n;
}

// Returns points from one end to the other within the region; empty if there is no such path.
std::vector<SurfacePoint> LineCover::bridge(const SurfacePoint& from,
                                            const SurfacePoint& to) const {
  const Vector3d step = to.position - from.position;
  const int n = std::max(2, static_cast<int>(std::ceil(step.norm() / 0.4)));
  std::vector<SurfacePoint> points;
  int triangle = from.triangle;
  for (int i = 1; i < n; ++i) {
    const SurfacePoint p =
        s_.project(from.position + step * (static_cast<double>(i) / n), triangle);
    triangle = p.triangle;
    const double d = s_.interpolate(depth_, p);
    if (d < r_.from + 0.3 || d > r_.from + 1.6)
      return {};
    points.push_back(p);
  }
  return points;
}

// Joins the front of `next` to the back of `line`, both shortened to where the joining bead begins.
void LineCover::append(Line& line, Line next) const {
  const std::size_t cut = deepFrom(line, true), skip = deepFrom(next, false);
  line.points.resize(line.points.size() - cut);
  line.depth.resize(line.points.size());
  for (const SurfacePoint& p : bridge(line.points.back(), next.points[skip])) {
    line.points.push_back(p);
    line.depth.push_back(r_.from + kJoinedEnd);
  }
  const auto from = static_cast<std::ptrdiff_t>(skip);
  line.points.insert(line.points.end(), next.points.begin() + from, next.points.end());
  line.depth.insert(line.depth.end(), next.depth.begin() + from, next.depth.end());
}

// Returns the place where a joining bead begins at an end of a line; nullopt if the line is too
// short or too close to the edge for one.
std::optional<SurfacePoint> LineCover::joint(const Line& line, bool back) const {
  const std::size_t cut = deepFrom(line, back);
  if (line.closed || cut + 1 >= line.points.size())
    return std::nullopt;
  return line.points[back ? line.points.size() - 1 - cut : cut];
}

void LineCover::reverse(Line& line) {
  std::ranges::reverse(line.points);
  std::ranges::reverse(line.depth);
}

// Joins lines of consecutive levels, from the first level on.
std::vector<LineCover::Line> LineCover::chains(double farthestMm, const base::RunContext& ctx) {
  std::vector<Line> chains;
  std::vector<std::vector<std::size_t>> byLevel;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    byLevel.resize(std::max(byLevel.size(), at(lines_[i].level) + 1));
    byLevel[at(lines_[i].level)].push_back(i);
  }
  for (Line& first : lines_) {
    if (std::exchange(first.used, true))
      continue;
    Line chain = first;
    for (int level = first.level + 1; at(level) < byLevel.size(); ++level) {
      ctx.checkpoint();
      const std::optional<SurfacePoint> from = joint(chain, true);
      if (!from)
        break;
      double nearest = farthestMm;
      Line* best = nullptr;
      bool bestBack = false;
      for (const std::size_t i : byLevel[at(level)])
        for (const bool back : {false, true}) {
          const std::optional<SurfacePoint> to =
              lines_[i].used ? std::nullopt : joint(lines_[i], back);
          const double d = to ? (to->position - from->position).norm() : nearest;
          if (d < nearest && !bridge(*from, *to).empty()) {
            nearest = d;
            best = &lines_[i];
            bestBack = back;
          }
        }
      if (!best)
        break;
      best->used = true;
      Line next = *best;
      if (bestBack)
        reverse(next);
      append(chain, std::move(next));
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

// Joins the ends of different chains, the nearest first.
void LineCover::joinChains(std::vector<Line>& chains, double farthestMm,
                           const base::RunContext& ctx) const {
  struct Pair {
    double distanceMm;
    std::size_t a, b;
    bool backOfA, backOfB;
  };
  for (bool joined = true; joined;) {
    joined = false;
    ctx.checkpoint();
    std::vector<Pair> pairs;
    std::vector<std::array<std::optional<SurfacePoint>, 2>> ends;
    for (const Line& chain : chains)
      ends.push_back({joint(chain, false), joint(chain, true)});
    for (std::size_t a = 0; a < chains.size(); ++a)
      for (std::size_t b = a + 1; b < chains.size(); ++b)
        for (const bool backOfA : {false, true})
          for (const bool backOfB : {false, true})
            if (const auto& p = ends[a][backOfA ? 1 : 0], &q = ends[b][backOfB ? 1 : 0]; p && q)
              if (const double d = (p->position - q->position).norm(); d < farthestMm)
                pairs.push_back({d, a, b, backOfA, backOfB});
    std::ranges::stable_sort(pairs, {}, &Pair::distanceMm);
    std::vector<char> taken(chains.size(), 0);
    for (const Pair& pair : pairs) {
      if (taken[pair.a] || taken[pair.b] ||
          bridge(*ends[pair.a][pair.backOfA ? 1 : 0], *ends[pair.b][pair.backOfB ? 1 : 0]).empty())
        continue;
      if (!pair.backOfA)
        reverse(chains[pair.a]);
      if (pair.backOfB)
        reverse(chains[pair.b]);
      append(chains[pair.a], std::move(chains[pair.b]));
      chains[pair.b].points.clear();
      taken[pair.a] = taken[pair.b] = 1;
      joined = true;
    }
    std::erase_if(chains, [](const Line& chain) { return chain.points.empty(); });
  }
}

std::vector<SurfaceCurve> LineCover::joined(double spacing, const base::RunContext& ctx) {
  std::vector<Line> all = chains(kFarthestJoin * spacing, ctx);
  joinChains(all, kFarthestJoin * spacing, ctx);
  std::vector<SurfaceCurve> curves;
  for (Line& chain : all)
    curves.push_back({std::move(chain.points), chain.closed});
  return curves;
}

EvenLines evenLines(const InfillRegion& r, const std::vector<double>& depth,
                    const std::vector<double>& across, const base::RunContext& ctx) {
  double low = INFINITY, high = -INFINITY, hatch = 0.0;
  std::size_t count = 0;
  for (std::size_t v = 0; v < depth.size(); ++v)
    if (depth[v] >= r.from) {
      low = std::min(low, across[v]);
      high = std::max(high, across[v]);
      hatch += r.hatchMm[v];
      ++count;
    }
  hatch /= static_cast<double>(count);
  const int n = std::max(1, static_cast<int>(std::lround((high - low) / hatch)));
  const double spacing = (high - low) / n;
  // Lines outside the region are discarded.
  std::vector<double> there(across.size(), std::numeric_limits<double>::quiet_NaN());
  for (const auto& t : r.surface.triangles)
    if (std::ranges::any_of(t, [&](int v) { return depth[at(v)] >= r.from + kOpenEnd; }))
      for (const int v : t)
        there[at(v)] = across[at(v)];
  LineCover lines(r, depth);
  const EvenIsolines levels(r.surface, there, low, spacing, n);
  for (int k = 0; k < n; ++k) {
    ctx.checkpoint();
    for (const SurfaceCurve& c : levels.curvesAt(k))
      lines.add(c, k);
  }
  return {lines.joined(spacing, ctx), spacing};
}

} // namespace voluta::toolpath
