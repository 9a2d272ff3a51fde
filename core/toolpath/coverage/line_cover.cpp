#include "toolpath/coverage/line_cover.h"

#include "base/index.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/surface_fields.h"

#include <cmath>
#include <limits>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

using base::at;

constexpr double kOpenEnd = 0.08; // [hatches] from the region's edge to an unjoined end
// [hatches] from the region's edge to the bead that joins two lines
constexpr double kJoinedEnd = 0.5;
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

std::vector<SurfaceCurve> LineCover::joined(double spacing, const base::RunContext& ctx) {
  std::vector<SurfaceCurve> curves;
  std::vector<Line>& lines = lines_;
  std::vector<std::vector<std::size_t>> byLevel;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    byLevel.resize(std::max(byLevel.size(), at(lines[i].level) + 1));
    byLevel[at(lines[i].level)].push_back(i);
  }
  for (std::size_t first = 0; first < lines.size(); ++first) {
    if (lines[first].used)
      continue;
    lines[first].used = true;
    if (lines[first].closed) {
      curves.push_back({lines[first].points, true});
      continue;
    }
    std::vector<SurfacePoint> chain = lines[first].points;
    std::vector<double> chainDepth = lines[first].depth;
    for (int level = lines[first].level + 1; at(level) < byLevel.size(); ++level) {
      ctx.checkpoint();
      // The end of the chain, and the nearest end in the next level that can be joined to it.
      Line end{chain, chainDepth, 0, false, false};
      const std::size_t cut = deepFrom(end, true);
      if (cut + 1 >= chain.size())
        break;
      const SurfacePoint from = chain[chain.size() - 1 - cut];
      double nearest = 2.5 * spacing;
      std::size_t best = lines.size(), bestCut = 0;
      bool bestBack = false;
      for (const std::size_t i : byLevel[at(level)]) {
        const Line& l = lines[i];
        if (l.used || l.closed)
          continue;
        for (const bool back : {false, true}) {
          const std::size_t k = deepFrom(l, back);
          if (k + 1 >= l.points.size())
            continue;
          const SurfacePoint& p = l.points[back ? l.points.size() - 1 - k : k];
          const double d = (p.position - from.position).norm();
          if (d < nearest && !bridge(from, p).empty()) {
            nearest = d;
            best = i;
            bestCut = k;
            bestBack = back;
          }
        }
      }
      if (best == lines.size())
        break;
      Line next = lines[best];
      lines[best].used = true;
      if (bestBack) {
        std::ranges::reverse(next.points);
        std::ranges::reverse(next.depth);
      }
      chain.resize(chain.size() - cut);
      chainDepth.resize(chain.size());
      for (const SurfacePoint& p : bridge(from, next.points[bestCut])) {
        chain.push_back(p);
        chainDepth.push_back(r_.from + kJoinedEnd);
      }
      const auto skip = static_cast<std::ptrdiff_t>(bestCut);
      chain.insert(chain.end(), next.points.begin() + skip, next.points.end());
      chainDepth.insert(chainDepth.end(), next.depth.begin() + skip, next.depth.end());
    }
    curves.push_back({std::move(chain), false});
  }
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
  const int n = std::max(1, static_cast<int>(std::lround((high - low) * r.density / hatch)));
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
