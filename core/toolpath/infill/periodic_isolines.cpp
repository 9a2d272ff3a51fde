#include "toolpath/infill/periodic_isolines.h"

#include "base/error.h"
#include "base/index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace voluta::toolpath {

namespace {

using base::at;

constexpr double kSamePlace = 1e-6; // mm

struct Crossing {
  SurfacePoint point;
  int next = -1, previous = -1;
};

// An edge, starting at its lower vertex, and the line's number counted from that vertex.
struct CrossingKey {
  int low, high;
  long line;
  auto operator<=>(const CrossingKey&) const = default;
};

class Tracer {
public:
  Tracer(const PatchSurface& s, const Winding& winding) : s_(s), winding_(winding) {}

  std::vector<SurfaceCurve> run(const base::RunContext& ctx) {
    for (std::size_t t = 0; t < s_.triangles.size(); ++t) {
      ctx.checkpoint();
      cross(static_cast<int>(t));
    }
    used_.assign(crossings_.size(), 0);
    for (std::size_t i = 0; i < crossings_.size(); ++i)
      if (crossings_[i].previous < 0)
        follow(static_cast<int>(i));
    for (std::size_t i = 0; i < crossings_.size(); ++i)
      if (!used_[i])
        follow(static_cast<int>(i));
    return std::move(curves_);
  }

private:
  double valueAt(int v) const { return winding_.at(s_.chart.at[at(v)]); }

  // A corner's value in its own chart, and the integer that shifts it to the first corner's sheet.
  // Comparisons use the unshifted value, which is the same in every triangle, so that a line
  // through a vertex passes it on the same side in all of them.
  struct Corner {
    int vertex = 0;
    double own = 0.0;
    long shift = 0;
    bool isAbove(long line) const { return own >= static_cast<double>(line - shift) + 0.5; }
    double value() const { return own + static_cast<double>(shift); }
  };

  // Adds all lines that cross a triangle.
  void cross(int triangle) {
    const auto& t = s_.triangles[at(triangle)];
    std::array<Corner, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2d d = s_.chart.between(t[0], t[k]);
      const double own = valueAt(t[k]),
                   value = valueAt(t[0]) + d.x() * winding_.perU + d.y() * winding_.perV;
      corner[k] = {t[k], own, std::lround(value - own)};
    }
    const auto [low, high] = std::minmax({corner[0].value(), corner[1].value(), corner[2].value()});
    const long last = static_cast<long>(std::floor(high + 0.5));
    for (long line = static_cast<long>(std::ceil(low - 0.5)) - 1; line <= last; ++line) {
      const auto isAbove = [&](std::size_t k) { return corner[k].isAbove(line); };
      const int count = isAbove(0) + isAbove(1) + isAbove(2);
      if (count == 0 || count == 3)
        continue;
      // k: the corner that is alone on its side of the line.
      const bool lone = count == 1;
      const std::size_t k = isAbove(0) == lone ? 0 : isAbove(1) == lone ? 1 : 2;
      int from = crossing(triangle, corner[k], corner[(k + 1) % 3], line),
          to = crossing(triangle, corner[(k + 2) % 3], corner[k], line);
      if (!lone)
        std::swap(from, to);
      crossings_[at(from)].next = to;
      crossings_[at(to)].previous = from;
    }
  }

  int crossing(int triangle, Corner a, Corner b, long line) {
    if (a.vertex > b.vertex)
      std::swap(a, b);
    const long own = line - a.shift;
    const auto [entry, isNew] =
        byEdge_.try_emplace({a.vertex, b.vertex, own}, static_cast<int>(crossings_.size()));
    if (isNew) {
      const double share = std::clamp((static_cast<double>(own) + 0.5 - a.own) /
                                          (b.own + static_cast<double>(b.shift - a.shift) - a.own),
                                      0.0, 1.0);
      crossings_.push_back(
          {{(1 - share) * s_.position[at(a.vertex)] + share * s_.position[at(b.vertex)],
            triangle}});
    }
    return entry->second;
  }

  void follow(int start) {
    SurfaceCurve c;
    int i = start;
    while (i >= 0 && !used_[at(i)]) {
      used_[at(i)] = 1;
      const SurfacePoint& p = crossings_[at(i)].point;
      if (c.points.empty() || (c.points.back().position - p.position).norm() > kSamePlace)
        c.points.push_back(p);
      i = crossings_[at(i)].next;
    }
    c.closed = i == start && c.points.size() > 2;
    if (c.points.size() >= 2)
      curves_.push_back(std::move(c));
  }

  const PatchSurface& s_;
  const Winding& winding_;
  std::vector<Crossing> crossings_;
  std::map<CrossingKey, int> byEdge_;
  std::vector<char> used_;
  std::vector<SurfaceCurve> curves_;
};

} // namespace

std::vector<SurfaceCurve> periodicIsolines(const PatchSurface& surface, const Winding& winding,
                                           const base::RunContext& ctx) {
  base::require(!surface.chart.empty(), "the surface has a chart");
  const double around = winding.perU * surface.chart.periodMm;
  base::require(std::abs(around - std::round(around)) < 1e-6, "whole lines around");
  return Tracer(surface, winding).run(ctx);
}

} // namespace voluta::toolpath
