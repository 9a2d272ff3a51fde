#include "toolpath/curve_tools.h"
#include "toolpath/infill.h"
#include "toolpath/regions.h"
#include "toolpath/surface_fields.h"
#include "toolpath/walls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

constexpr double kOpenEnd = 0.08;  // hatches from the region's edge to an end that isn't joined
constexpr double kJoinedEnd = 0.5; // and to the bead that joins two lines
constexpr double kNarrow = 4.2;    // hatches: shallower parts are filled along their edge

// A function of (nearly) unit gradient whose isolines are the lines.
std::vector<double> acrossLines(const PatchSurface& s, int layer) {
  Vector3d mean = Vector3d::Zero(), centre = Vector3d::Zero();
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    mean += s.triangleArea[t] * s.triangleNormal[t];
    const auto& tri = s.triangles[t];
    centre += s.triangleArea[t] / 3 *
              (s.position[at(tri[0])] + s.position[at(tri[1])] + s.position[at(tri[2])]);
  }
  const double angle = (layer % 2 == 0 ? 0.25 : -0.25) * std::numbers::pi;
  Vector3d normal(std::cos(angle), std::sin(angle), 0);
  if (mean.norm() > 0.1 * s.areaMm2) {
    const Vector3d m = mean.normalized();
    // Turned with the patch's own mean plane, so that no patch is cut along itself.
    normal = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), m) * normal;
  }
  std::vector<double> u(s.position.size());
  for (std::size_t v = 0; v < u.size(); ++v)
    u[v] = normal.dot(s.position[v]);
  // Plane cuts lie further apart on the surface where it leans along their normal. As long as that
  // is little, straight lines are better than bent ones.
  constexpr double kLeastSine = 0.97;
  double leaning = 0.0;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const double c = normal.dot(s.triangleNormal[t]);
    if (c * c > 1 - kLeastSine * kLeastSine)
      leaning += s.triangleArea[t];
  }
  if (leaning < 0.02 * s.areaMm2)
    return u;
  // A plane through the middle may miss the surface where it is hollow; through a vertex it can't.
  std::vector<double> sorted = u;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(u.size() / 2));
  std::vector<double> geodesic = distanceToSection(s, normal, sorted[u.size() / 2] + 1e-7);
  const bool whole =
      !geodesic.empty() && std::ranges::all_of(geodesic, [](double d) { return std::isfinite(d); });
  return whole ? geodesic : u;
}

struct Line {
  std::vector<SurfacePoint> points;
  std::vector<double> depth; // per point
  int level = 0;
  bool closed = false, used = false;
};

class Zigzag {
public:
  explicit Zigzag(const InfillRegion& r)
      : r_(r), s_(r.surface), across_(acrossLines(s_, r.layer)) {}

  std::vector<SurfaceCurve> fill() {
    const Regions regions = regionsAbove(s_, r_.depth, r_.from);
    std::vector<double> deepest(at(regions.count), 0.0);
    for (std::size_t v = 0; v < r_.depth.size(); ++v)
      if (regions.ofVertex[v] >= 0) {
        double& d = deepest[at(regions.ofVertex[v])];
        d = std::max(d, r_.depth[v]);
      }
    for (int i = 0; i < regions.count; ++i) {
      std::vector<double> own = r_.depth;
      for (std::size_t v = 0; v < own.size(); ++v)
        if (regions.ofVertex[v] != i && own[v] >= r_.from)
          own[v] = r_.from - 1;
      if (deepest[at(i)] - r_.from < kNarrow) {
        InfillRegion narrow{s_, own, r_.hatchMm, r_.from, r_.density, r_.layer};
        for (SurfaceCurve& c : concentricInfill(narrow))
          curves_.push_back(std::move(c));
      } else {
        fillRegion(own);
      }
    }
    return std::move(curves_);
  }

private:
  void fillRegion(const std::vector<double>& depth) {
    double low = INFINITY, high = -INFINITY, hatch = 0.0;
    std::size_t count = 0;
    for (std::size_t v = 0; v < depth.size(); ++v)
      if (depth[v] >= r_.from) {
        low = std::min(low, across_[v]);
        high = std::max(high, across_[v]);
        hatch += r_.hatchMm[v];
        ++count;
      }
    hatch /= static_cast<double>(count);
    const int n = std::max(1, static_cast<int>(std::lround((high - low) * r_.density / hatch)));
    const double spacing = (high - low) / n;
    std::vector<Line> lines;
    for (int k = 0; k < n; ++k)
      for (const SurfaceCurve& c : isolines(s_, across_, low + (k + 0.5) * spacing))
        clip(c, depth, k, lines);
    join(lines, depth, spacing);
  }

  // The parts of a curve that lie in the region.
  void clip(const SurfaceCurve& c, const std::vector<double>& depth, int level,
            std::vector<Line>& lines) const {
    const double edge = r_.from + kOpenEnd;
    const std::size_t n = c.points.size();
    std::vector<double> d(n);
    for (std::size_t i = 0; i < n; ++i)
      d[i] = s_.interpolate(depth, c.points[i]);
    const auto firstOutside = std::ranges::find_if(d, [&](double x) { return x < edge; });
    if (firstOutside == d.end()) {
      lines.push_back({c.points, d, level, c.closed, false});
      return;
    }
    const std::size_t start = c.closed ? static_cast<std::size_t>(firstOutside - d.begin()) : 0;
    Line line;
    const auto finish = [&] {
      SurfaceCurve whole{line.points, false};
      if (line.points.size() >= 2 && lengthOf(whole) > 0.4) {
        line.level = level;
        lines.push_back(line);
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

  // Where a line, walked from its end, is deep enough for the joining bead; its size when nowhere.
  std::size_t deepFrom(const Line& line, bool fromBack) const {
    const std::size_t n = line.points.size();
    for (std::size_t i = 0; i < n; ++i)
      if (line.depth[fromBack ? n - 1 - i : i] >= r_.from + kJoinedEnd)
        return i;
    return n;
  }

  // Points between two ends, through the region only; empty when there is no such way.
  std::vector<SurfacePoint> bridge(const SurfacePoint& from, const SurfacePoint& to,
                                   const std::vector<double>& depth) const {
    const Vector3d step = to.position - from.position;
    const int n = std::max(2, static_cast<int>(std::ceil(step.norm() / 0.4)));
    std::vector<SurfacePoint> points;
    int triangle = from.triangle;
    for (int i = 1; i < n; ++i) {
      const SurfacePoint p =
          s_.project(from.position + step * (static_cast<double>(i) / n), triangle);
      triangle = p.triangle;
      const double d = s_.interpolate(depth, p);
      if (d < r_.from + 0.3 || d > r_.from + 1.6)
        return {};
      points.push_back(p);
    }
    return points;
  }

  void join(std::vector<Line>& lines, const std::vector<double>& depth, double spacing) {
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
        curves_.push_back({lines[first].points, true});
        continue;
      }
      std::vector<SurfacePoint> chain = lines[first].points;
      std::vector<double> chainDepth = lines[first].depth;
      for (int level = lines[first].level + 1; at(level) < byLevel.size(); ++level) {
        // The chain's end, and the nearest end of the next level that can be joined to it.
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
            if (d < nearest && !bridge(from, p, depth).empty()) {
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
        for (const SurfacePoint& p : bridge(from, next.points[bestCut], depth)) {
          chain.push_back(p);
          chainDepth.push_back(r_.from + kJoinedEnd);
        }
        const auto skip = static_cast<std::ptrdiff_t>(bestCut);
        chain.insert(chain.end(), next.points.begin() + skip, next.points.end());
        chainDepth.insert(chainDepth.end(), next.depth.begin() + skip, next.depth.end());
      }
      curves_.push_back({std::move(chain), false});
    }
  }

  const InfillRegion& r_;
  const PatchSurface& s_;
  std::vector<double> across_;
  std::vector<SurfaceCurve> curves_;
};
} // namespace

std::vector<SurfaceCurve> zigzagInfill(const InfillRegion& region) {
  if (std::ranges::none_of(region.depth, [&](double d) { return d >= region.from; }))
    return {};
  return Zigzag(region).fill();
}

} // namespace voluta::toolpath
