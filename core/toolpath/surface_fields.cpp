#include "toolpath/surface_fields.h"

#include "base/error.h"
#include "base/index.h"
#include "geometry/nearest_share.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

using base::at;

Vector3d closestOnSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  return a + geometry::nearestShare(p, a, b) * (b - a);
}

// Returns the length of the circular arc over a chord that leaves the tangent planes at both ends;
// infinity if it is at least `limit`.
double arcLength(const Vector3d& p, const Vector3d& np, const Vector3d& q, const Vector3d& nq,
                 double limit) {
  const Vector3d c = p - q;
  const double squared = c.squaredNorm();
  if (squared >= limit * limit)
    return INFINITY;
  const double chord = std::sqrt(squared);
  if (chord < 1e-9)
    return chord;
  const double s1 = std::min(1.0, std::abs(c.dot(np)) / chord);
  const double s2 = std::min(1.0, std::abs(c.dot(nq)) / chord);
  if (s1 + s2 < 2e-3) {
    const double half = 0.5 * (s1 + s2);
    return chord * (1 + half * half / 6);
  }
  const double half = std::min(1.2, 0.5 * (std::asin(s1) + std::asin(s2)));
  return chord * half / std::sin(half);
}

struct Front {
  double distance;
  int vertex;
  bool operator>(const Front& o) const {
    return distance != o.distance ? distance > o.distance : vertex > o.vertex;
  }
};
using FrontQueue = std::priority_queue<Front, std::vector<Front>, std::greater<>>;

// The segments that continue each segment at its ends; -1: none.
std::vector<std::array<int, 2>> neighbouringSegments(const std::vector<SourceSegment>& sources) {
  std::vector<std::array<int, 2>> neighbours(sources.size(), {-1, -1});
  std::vector<int> byStart(sources.size());
  std::iota(byStart.begin(), byStart.end(), 0);
  const auto key = [](const Vector3d& p) { return std::tuple(p.x(), p.y(), p.z()); };
  const auto startOf = [&](int i) { return key(sources[at(i)].a); };
  std::ranges::sort(byStart, {}, startOf);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto next = std::ranges::lower_bound(byStart, key(sources[i].b), {}, startOf);
    if (next == byStart.end() || sources[at(*next)].a != sources[i].b)
      continue;
    neighbours[i][1] = *next;
    neighbours[at(*next)][0] = static_cast<int>(i);
  }
  return neighbours;
}
} // namespace

std::vector<SourceSegment> boundarySegments(const PatchSurface& s) {
  std::vector<SourceSegment> out;
  out.reserve(s.boundary.size());
  for (const auto& e : s.boundary)
    out.push_back({s.position[at(e[0])], s.position[at(e[1])], e[2]});
  return out;
}

BoundaryParts boundaryParts(const PatchSurface& s) {
  BoundaryParts parts;
  for (std::size_t i = 0; i < s.boundary.size(); ++i) {
    const auto& e = s.boundary[i];
    (s.isSeam(i) ? parts.seams : parts.surface)
        .push_back({s.position[at(e[0])], s.position[at(e[1])], e[2]});
  }
  return parts;
}

std::vector<SourceSegment> segmentsOf(const PatchSurface&,
                                      const std::vector<SurfaceCurve>& curves) {
  std::vector<SourceSegment> out;
  for (const SurfaceCurve& c : curves) {
    const std::size_t n = c.points.size();
    for (std::size_t i = 0; i + 1 < n + (c.closed ? 1 : 0); ++i) {
      const SurfacePoint &p = c.points[i], &q = c.points[(i + 1) % n];
      out.push_back({p.position, q.position, p.triangle});
      // The ends can be in different triangles; the front has to start from both.
      if (q.triangle != p.triangle)
        out.push_back({p.position, q.position, q.triangle});
    }
  }
  return out;
}

SegmentDistances nearestSegments(const PatchSurface& s, const std::vector<SourceSegment>& sources,
                                 double farMm, const std::vector<char>& onwards) {
  base::require(onwards.empty() || onwards.size() == s.position.size(), "a mark per vertex");
  std::vector<double> distance(s.position.size(), farMm);
  std::vector<int> nearest(s.position.size(), -1);
  std::vector<double> inverse(sources.size()); // of squared lengths
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const double squared = (sources[i].b - sources[i].a).squaredNorm();
    inverse[i] = squared > 0.0 ? 1.0 / squared : 0.0;
  }
  const auto offer = [&](int v, int source) {
    const SourceSegment& e = sources[at(source)];
    const Vector3d& p = s.position[at(v)];
    const Vector3d along = e.b - e.a;
    const Vector3d q = e.a + std::clamp(along.dot(p - e.a) * inverse[at(source)], 0.0, 1.0) * along;
    const double limit = distance[at(v)];
    double d = INFINITY;
    if (!s.planeNormal)
      d = arcLength(p, s.normal[at(v)], q, s.triangleNormal[at(e.triangle)], limit);
    else if (const double squared = (p - q).squaredNorm(); squared < limit * limit)
      d = std::sqrt(squared);
    if (!(d < limit))
      return false;
    distance[at(v)] = d;
    nearest[at(v)] = source;
    return true;
  };
  const auto neighbours =
      s.planeNormal ? neighbouringSegments(sources) : std::vector<std::array<int, 2>>();
  // On a plane, the nearest segment of a vertex may be none of its neighbours' where triangles are
  // no smaller than segments: beside an accepted one there may be a nearer one.
  const auto offerWithNeighbours = [&](int v, int source) {
    if (!offer(v, source))
      return false;
    if (!neighbours.empty())
      for (const std::size_t side : {0U, 1U})
        for (int i = neighbours[at(source)][side]; i >= 0 && offer(v, i);)
          i = neighbours[at(i)][side];
    return true;
  };
  for (std::size_t i = 0; i < sources.size(); ++i)
    for (const int v : s.triangles[at(sources[i].triangle)])
      offer(v, static_cast<int>(i));
  const auto continues = [&](int v) { return onwards.empty() || onwards[at(v)] != 0; };
  std::vector<Front> fronts;
  for (std::size_t v = 0; v < distance.size(); ++v)
    if (nearest[v] >= 0 && continues(static_cast<int>(v)))
      fronts.push_back({distance[v], static_cast<int>(v)});
  FrontQueue queue(std::greater<>(), std::move(fronts));
  while (!queue.empty()) {
    const Front f = queue.top();
    queue.pop();
    if (f.distance > distance[at(f.vertex)])
      continue;
    const int source = nearest[at(f.vertex)];
    const bool open = s.isOnBoundary[at(f.vertex)] != 0;
    for (const int* t = s.ringBegin(f.vertex); t != s.ringEnd(f.vertex); ++t) {
      const auto& corners = s.triangles[at(*t)];
      const std::size_t k = corners[0] == f.vertex ? 0 : corners[1] == f.vertex ? 1 : 2;
      // Around an inner vertex, each neighbour is the next corner of exactly one triangle.
      const int next = corners[(k + 1) % 3], last = corners[(k + 2) % 3];
      if (nearest[at(next)] != source && offerWithNeighbours(next, source) && continues(next))
        queue.push({distance[at(next)], next});
      if (open && nearest[at(last)] != source && offerWithNeighbours(last, source) &&
          continues(last))
        queue.push({distance[at(last)], last});
    }
  }
  return {std::move(distance), std::move(nearest)};
}

std::vector<double> distanceToSegments(const PatchSurface& s,
                                       const std::vector<SourceSegment>& sources, double farMm,
                                       const std::vector<char>& onwards) {
  return nearestSegments(s, sources, farMm, onwards).mm;
}

std::vector<double> distanceToSection(const PatchSurface& s, const Vector3d& normal,
                                      double offset) {
  const std::size_t n = s.position.size();
  std::vector<double> side(n);
  for (std::size_t v = 0; v < n; ++v)
    side[v] = normal.dot(s.position[v]) - offset;
  const auto section = isolines(s, side, 0.0);
  if (section.empty())
    return {};
  const auto sources = segmentsOf(s, section);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> u(n, kFar);
  std::vector<char> fixed(n, 0);
  FrontQueue queue;
  for (const SourceSegment& e : sources)
    for (const int v : s.triangles[at(e.triangle)]) {
      const Vector3d q = closestOnSegment(s.position[at(v)], e.a, e.b);
      const double d = arcLength(s.position[at(v)], s.normal[at(v)], q,
                                 s.triangleNormal[at(e.triangle)], u[at(v)]);
      if (d < u[at(v)]) {
        u[at(v)] = d;
        queue.push({d, v});
      }
    }
  const auto update = [&](int a, int b, int c) {
    // Updates c from a (fixed) and b: the front through both, assumed planar within the triangle.
    const Vector3d ea = s.position[at(a)] - s.position[at(c)];
    double best = u[at(a)] + ea.norm();
    if (fixed[at(b)]) {
      const Vector3d eb = s.position[at(b)] - s.position[at(c)];
      const double aa = ea.dot(ea), ab = ea.dot(eb), bb = eb.dot(eb), det = aa * bb - ab * ab;
      if (det > 1e-12 * aa * bb) {
        Eigen::Matrix2d q;
        q << bb / det, -ab / det, -ab / det, aa / det;
        const Eigen::Vector2d d(u[at(a)], u[at(b)]), one(1, 1);
        const double p2 = one.dot(q * one), p1 = one.dot(q * d), p0 = d.dot(q * d) - 1;
        const double disc = p1 * p1 - p2 * p0;
        if (disc >= 0) {
          const double t = (p1 + std::sqrt(disc)) / p2;
          const Eigen::Vector2d w = q * (d - t * one);
          if (w[0] <= 0 && w[1] <= 0)
            best = std::min(best, t);
        }
      }
    }
    if (best < u[at(c)] - 1e-12) {
      u[at(c)] = best;
      queue.push({best, c});
    }
  };
  while (!queue.empty()) {
    const Front f = queue.top();
    queue.pop();
    if (fixed[at(f.vertex)] || f.distance > u[at(f.vertex)])
      continue;
    fixed[at(f.vertex)] = 1;
    for (const int* t = s.ringBegin(f.vertex); t != s.ringEnd(f.vertex); ++t) {
      const auto& tri = s.triangles[at(*t)];
      for (std::size_t k = 0; k < 3; ++k)
        if (tri[k] == f.vertex) {
          const int b = tri[(k + 1) % 3], c = tri[(k + 2) % 3];
          if (!fixed[at(b)])
            update(f.vertex, c, b);
          if (!fixed[at(c)])
            update(f.vertex, b, c);
        }
    }
  }
  for (std::size_t v = 0; v < n; ++v)
    if (side[v] < 0)
      u[v] = -u[v];
  return u;
}

namespace {
// `triangleAt(k)`, k below count: the candidate triangles, ascending.
template <typename TriangleAt>
std::vector<SurfaceCurve> isolinesAmong(const PatchSurface& s, const std::vector<double>& values,
                                        double level, std::size_t triangleCount,
                                        TriangleAt&& triangleAt) {
  // One crossing per edge; within a triangle the curve connects its two crossings.
  struct Crossing {
    SurfacePoint point;
    int next = -1, previous = -1;
  };
  std::vector<Crossing> crossings;
  std::unordered_map<std::uint64_t, int> byEdge;
  const auto above = [&](int v) { return values[at(v)] >= level; };
  const auto crossing = [&](int a, int b, int triangle) {
    const auto lo = static_cast<std::uint64_t>(std::min(a, b)),
               hi = static_cast<std::uint64_t>(std::max(a, b));
    const auto [it, fresh] = byEdge.try_emplace(lo << 32 | hi, static_cast<int>(crossings.size()));
    if (fresh) {
      if (a > b)
        std::swap(a, b);
      const double va = values[at(a)], vb = values[at(b)];
      const double t = std::clamp((level - va) / (vb - va), 0.0, 1.0);
      crossings.push_back({{(1 - t) * s.position[at(a)] + t * s.position[at(b)], triangle}});
    }
    return it->second;
  };
  for (std::size_t among = 0; among < triangleCount; ++among) {
    const std::size_t i = triangleAt(among);
    const auto& t = s.triangles[i];
    const int count = above(t[0]) + above(t[1]) + above(t[2]);
    if (count == 0 || count == 3 ||
        !std::isfinite(values[at(t[0])] + values[at(t[1])] + values[at(t[2])]))
      continue;
    // k: the vertex that is alone on its side of the level.
    const bool lone = count == 1;
    const std::size_t k = above(t[0]) == lone ? 0 : above(t[1]) == lone ? 1 : 2;
    const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    int from = crossing(a, b, static_cast<int>(i)), to = crossing(c, a, static_cast<int>(i));
    if (!lone)
      std::swap(from, to);
    crossings[at(from)].next = to;
    crossings[at(to)].previous = from;
  }
  std::vector<SurfaceCurve> curves;
  std::vector<char> used(crossings.size(), 0);
  const auto follow = [&](int start) {
    SurfaceCurve c;
    int i = start;
    while (i >= 0 && !used[at(i)]) {
      used[at(i)] = 1;
      const SurfacePoint& p = crossings[at(i)].point;
      if (c.points.empty() || (c.points.back().position - p.position).norm() > 1e-6)
        c.points.push_back(p);
      i = crossings[at(i)].next;
    }
    c.closed = i == start && c.points.size() > 2;
    if (c.points.size() >= 2)
      curves.push_back(std::move(c));
  };
  for (std::size_t i = 0; i < crossings.size(); ++i)
    if (crossings[i].previous < 0)
      follow(static_cast<int>(i));
  for (std::size_t i = 0; i < crossings.size(); ++i)
    if (!used[i])
      follow(static_cast<int>(i));
  return curves;
}
} // namespace

std::vector<SurfaceCurve> isolines(const PatchSurface& s, const std::vector<double>& values,
                                   double level) {
  return isolinesAmong(s, values, level, s.triangles.size(), [](std::size_t k) { return k; });
}

EvenIsolines::EvenIsolines(const PatchSurface& s, const std::vector<double>& values, double low,
                           double spacing, int count)
    : s_(s), values_(values), low_(low), spacing_(spacing), start_(at(count) + 1, 0) {
  // Levels that cross a triangle, plus one on either side to allow for rounding.
  const auto forLevels = [&](std::size_t i, auto&& f) {
    const auto& t = s_.triangles[i];
    const double a = values_[at(t[0])], b = values_[at(t[1])], c = values_[at(t[2])];
    if (!std::isfinite(a + b + c))
      return;
    const double from = std::max(std::floor((std::min({a, b, c}) - low_) / spacing_ - 0.5), 0.0),
                 to = std::min(std::ceil((std::max({a, b, c}) - low_) / spacing_ - 0.5),
                               count - 1.0);
    for (double k = from; k <= to; ++k)
      f(static_cast<std::size_t>(k));
  };
  for (std::size_t i = 0; i < s_.triangles.size(); ++i)
    forLevels(i, [&](std::size_t k) { ++start_[k + 1]; });
  for (std::size_t k = 1; k < start_.size(); ++k)
    start_[k] += start_[k - 1];
  triangle_.resize(start_.back());
  std::vector<std::size_t> fill(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < s_.triangles.size(); ++i)
    forLevels(i, [&](std::size_t k) { triangle_[fill[k]++] = i; });
}

std::vector<SurfaceCurve> EvenIsolines::curvesAt(int k) const {
  const std::size_t begin = start_[at(k)];
  return isolinesAmong(s_, values_, low_ + (k + 0.5) * spacing_, start_[at(k) + 1] - begin,
                       [&](std::size_t n) { return triangle_[begin + n]; });
}

} // namespace voluta::toolpath
