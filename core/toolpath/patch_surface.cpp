#include "toolpath/patch_surface.h"

#include "base/error.h"
#include "base/index.h"
#include "base/mixed_bits.h"
#include "geometry/triangle_queries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

using base::at;

// Splits every edge longer than the limit once; returns whether any was split.
class EdgeSplitter {
public:
  // marks: per vertex; splits only edges between marked vertices. Empty: all edges.
  EdgeSplitter(PatchSurface& s, double limit, std::vector<char> marks = {})
      : s_(s), limit2_(limit * limit), marks_(std::move(marks)) {}

  bool pass() {
    middle_.clear();
    std::vector<std::array<int, 3>> out;
    out.reserve(s_.triangles.size() * 2);
    for (const auto& t : s_.triangles) {
      std::array<int, 3> m{};
      for (std::size_t k = 0; k < 3; ++k)
        m[k] = middleOf(t[k], t[(k + 1) % 3]);
      split(t, m, out);
    }
    s_.triangles = std::move(out);
    return !middle_.empty();
  }

private:
  int middleOf(int a, int b) {
    if ((s_.position[at(a)] - s_.position[at(b)]).squaredNorm() <= limit2_)
      return -1;
    if (!marks_.empty() && !(marks_[at(a)] && marks_[at(b)]))
      return -1;
    const auto lo = static_cast<std::uint64_t>(std::min(a, b)),
               hi = static_cast<std::uint64_t>(std::max(a, b));
    const auto [it, fresh] =
        middle_.try_emplace(lo << 32 | hi, static_cast<int>(s_.position.size()));
    if (fresh) {
      if (!marks_.empty())
        marks_.push_back(1);
      const auto mix = [&](auto& values) {
        values.push_back(((values[at(a)] + values[at(b)]) / 2.0).eval());
      };
      mix(s_.position);
      mix(s_.direction);
      mix(s_.clearDirection);
      for (auto* v : {&s_.direction, &s_.clearDirection})
        if (v->back().norm() > 1e-6)
          v->back().normalize();
        else
          v->back() = (*v)[at(a)];
      s_.thicknessMm.push_back((s_.thicknessMm[at(a)] + s_.thicknessMm[at(b)]) / 2.0);
      if (!s_.seam.empty())
        s_.seam.push_back(s_.seam[at(a)] & s_.seam[at(b)]);
      if (!s_.chart.empty())
        s_.chart.at.push_back(s_.chart.blend(a, b, 0.5));
    }
    return it->second;
  }

  double length2(int a, int b) const {
    return (s_.position[at(a)] - s_.position[at(b)]).squaredNorm();
  }

  void split(const std::array<int, 3>& t, const std::array<int, 3>& m,
             std::vector<std::array<int, 3>>& out) const {
    const int count = (m[0] >= 0) + (m[1] >= 0) + (m[2] >= 0);
    if (count == 0) {
      out.push_back(t);
    } else if (count == 3) {
      out.push_back({t[0], m[0], m[2]});
      out.push_back({m[0], t[1], m[1]});
      out.push_back({m[2], m[1], t[2]});
      out.push_back({m[0], m[1], m[2]});
    } else if (count == 1) {
      const std::size_t k = m[0] >= 0 ? 0 : m[1] >= 0 ? 1 : 2;
      const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      out.push_back({a, m[k], c});
      out.push_back({m[k], b, c});
    } else {
      // Edge a b is not split; cut off c and split the remaining quadrilateral along its shorter
      // diagonal.
      const std::size_t k = m[0] < 0 ? 0 : m[1] < 0 ? 1 : 2;
      const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      const int bc = m[(k + 1) % 3], ca = m[(k + 2) % 3];
      out.push_back({ca, bc, c});
      if (length2(a, bc) <= length2(b, ca)) {
        out.push_back({a, b, bc});
        out.push_back({a, bc, ca});
      } else {
        out.push_back({a, b, ca});
        out.push_back({b, bc, ca});
      }
    }
  }

  PatchSurface& s_;
  double limit2_;
  std::vector<char> marks_;
  std::unordered_map<std::uint64_t, int> middle_;
};

constexpr double kPlaneMm = 1e-6; // maximum distance from the plane
constexpr double kFacesAligned = 1 - 1e-9;

// Returns the common normal of the triangles if they are coplanar and face the same way.
std::optional<Vector3d> commonPlane(const PatchSurface& s) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    sum += s.triangleArea[t] * s.triangleNormal[t];
  if (!(s.areaMm2 > 0.0) || sum.norm() < kFacesAligned * s.areaMm2)
    return std::nullopt;
  const Vector3d normal = sum.normalized();
  const double offset = normal.dot(s.position.front());
  for (const Vector3d& p : s.position)
    if (std::abs(normal.dot(p) - offset) > kPlaneMm)
      return std::nullopt;
  return normal;
}
} // namespace

PatchSurface PatchSurface::refine(const layers::Patch& patch, double edgeMm) {
  const std::size_t n = patch.surface.vertices.size();
  base::require(patch.thicknessMm.size() == n && patch.direction.size() == n &&
                    patch.clearDirection.size() == n &&
                    (patch.innerRim.empty() || patch.innerRim.size() == n) &&
                    (patch.chart.empty() || patch.chart.at.size() == n),
                "a patch has one thickness and two directions a vertex");
  base::require(edgeMm > 0, "edge length is positive");
  PatchSurface s;
  s.position = patch.surface.vertices;
  s.thicknessMm = patch.thicknessMm;
  s.direction = patch.direction;
  s.clearDirection = patch.clearDirection;
  s.seam = patch.innerRim;
  s.chart = patch.chart;
  s.triangles = patch.surface.triangles;
  EdgeSplitter splitter(s, edgeMm);
  while (splitter.pass()) {
  }
  s.link();
  return s;
}

PatchSurface PatchSurface::refinedAt(std::vector<char> marks, double edgeMm) const {
  base::require(marks.size() == position.size(), "one mark a vertex");
  base::require(edgeMm > 0, "edge length is positive");
  PatchSurface s;
  s.position = position;
  s.thicknessMm = thicknessMm;
  s.direction = direction;
  s.clearDirection = clearDirection;
  s.seam = seam;
  s.chart = chart;
  s.triangles = triangles;
  EdgeSplitter splitter(s, edgeMm, std::move(marks));
  while (splitter.pass()) {
  }
  s.link();
  return s;
}

void PatchSurface::link() {
  const std::size_t n = position.size();
  ringStart_.assign(n + 1, 0);
  for (const auto& t : triangles)
    for (const int v : t)
      ++ringStart_[at(v) + 1];
  for (std::size_t v = 0; v < n; ++v)
    ringStart_[v + 1] += ringStart_[v];
  ring_.resize(3 * triangles.size());
  std::vector<int> fill(ringStart_.begin(), ringStart_.end() - 1);
  normal.assign(n, Vector3d::Zero());
  triangleArea.resize(triangles.size());
  triangleNormal.resize(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    const Vector3d cross =
        (position[at(t[1])] - position[at(t[0])]).cross(position[at(t[2])] - position[at(t[0])]);
    const double twice = cross.norm();
    triangleArea[i] = twice / 2;
    triangleNormal[i] = twice > 1e-14 ? (cross / twice).eval() : Vector3d::Zero();
    areaMm2 += twice / 2;
    volumeMm3 +=
        twice / 6 * (thicknessMm[at(t[0])] + thicknessMm[at(t[1])] + thicknessMm[at(t[2])]);
    for (const int v : t) {
      ring_[at(fill[at(v)]++)] = static_cast<int>(i);
      normal[at(v)] += cross;
    }
  }
  for (std::size_t v = 0; v < n; ++v)
    normal[v] = normal[v].norm() > 1e-14 ? normal[v].normalized() : direction[v];
  // At a vertex surrounded by triangles every outgoing edge is also an incoming one, so that the
  // hashes cancel: all its edges are shared.
  std::vector<std::uint64_t> open(n, 0);
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      open[at(t[k])] += base::mixedBits(at(t[(k + 1) % 3])) - base::mixedBits(at(t[(k + 2) % 3]));
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangles[i][k], b = triangles[i][(k + 1) % 3];
      bool shared = open[at(a)] == 0 || open[at(b)] == 0;
      for (const int* j = ringBegin(a); j != ringEnd(a) && !shared; ++j)
        if (*j != static_cast<int>(i))
          shared = std::ranges::find(triangles[at(*j)], b) != triangles[at(*j)].end();
      if (!shared)
        boundary.push_back({a, b, static_cast<int>(i)});
    }
  isOnBoundary.assign(n, 0);
  for (const auto& e : boundary)
    isOnBoundary[at(e[0])] = isOnBoundary[at(e[1])] = 1;
  planeNormal = commonPlane(*this);
}

Vector3d PatchSurface::barycentric(const SurfacePoint& p) const {
  const auto& t = triangles[at(p.triangle)];
  const Vector3d &a = position[at(t[0])], &b = position[at(t[1])], &c = position[at(t[2])];
  const Vector3d e1 = b - a, e2 = c - a, d = p.position - a;
  const double a11 = e1.dot(e1), a12 = e1.dot(e2), a22 = e2.dot(e2);
  const double det = a11 * a22 - a12 * a12;
  if (!(det > 1e-14 * a11 * a22)) {
    // Degenerate triangle: interpolate along its longer edge.
    const double u = a11 > 0 ? std::clamp(e1.dot(d) / a11, 0.0, 1.0) : 0.0;
    return {1 - u, u, 0};
  }
  double v = (a22 * e1.dot(d) - a12 * e2.dot(d)) / det;
  double w = (a11 * e2.dot(d) - a12 * e1.dot(d)) / det;
  double u = 1 - v - w;
  u = std::max(u, 0.0), v = std::max(v, 0.0), w = std::max(w, 0.0);
  return Vector3d(u, v, w) / (u + v + w);
}

double PatchSurface::interpolate(const std::vector<double>& values, const SurfacePoint& p) const {
  const Vector3d w = barycentric(p);
  const auto& t = triangles[at(p.triangle)];
  return w[0] * values[at(t[0])] + w[1] * values[at(t[1])] + w[2] * values[at(t[2])];
}

Vector3d PatchSurface::interpolate(const std::vector<Vector3d>& values,
                                   const SurfacePoint& p) const {
  const Vector3d w = barycentric(p);
  const auto& t = triangles[at(p.triangle)];
  const Vector3d v = w[0] * values[at(t[0])] + w[1] * values[at(t[1])] + w[2] * values[at(t[2])];
  return v.norm() > 1e-6 ? v.normalized() : values[at(t[0])];
}

// Returns whether `q` is the foot of `point` on the triangle and so far from its edges that no
// neighbour is closer, unless the surface folds back over the triangle.
bool PatchSurface::isFootInside(int triangle, const Vector3d& point, const Vector3d& q) const {
  const Vector3d off = point - q;
  const double away = off.squaredNorm();
  if (away < 1e-18)
    return true;
  const auto& t = triangles[at(triangle)];
  const Vector3d& n = triangleNormal[at(triangle)];
  const double along = off.dot(n);
  if (away - along * along > 1e-9 * away)
    return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d& a = position[at(t[k])];
    const Vector3d edge = position[at(t[(k + 1) % 3])] - a;
    const double inside = n.cross(edge).dot(q - a);
    if (inside <= 0.0 || inside * inside < 4.0 * away * edge.squaredNorm())
      return false;
  }
  return true;
}

// Returns the triangle across the edge that separates the point most from a triangle of a plane.
// Returns the triangle itself if no edge separates them, -1 at the boundary.
int PatchSurface::crossedTowards(const Vector3d& point, int triangle) const {
  const auto& t = triangles[at(triangle)];
  double lowest = 0.0;
  std::size_t over = 3;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d& a = position[at(t[k])];
    const double outside = (position[at(t[(k + 1) % 3])] - a).cross(point - a).dot(*planeNormal);
    if (outside < lowest) {
      lowest = outside;
      over = k;
    }
  }
  if (over == 3)
    return triangle;
  const int a = t[over], b = t[(over + 1) % 3];
  for (const int* i = ringBegin(a); i != ringEnd(a); ++i)
    if (*i != triangle && std::ranges::find(triangles[at(*i)], b) != triangles[at(*i)].end())
      return *i;
  return -1;
}

SurfacePoint PatchSurface::project(const Vector3d& point, int start) const {
  constexpr int kMaxCrossed = 100;
  for (int step = 0; planeNormal && step < kMaxCrossed; ++step) {
    const int next = crossedTowards(point, start);
    if (next == start)
      return {point -
                  planeNormal->dot(point - position[at(triangles[at(start)][0])]) * *planeNormal,
              start};
    if (next < 0)
      break;
    start = next;
  }
  SurfacePoint best{position[at(triangles[at(start)][0])], start};
  double minimum = (best.position - point).squaredNorm();
  const auto tryTriangle = [&](int i) {
    const auto& t = triangles[at(i)];
    const Vector3d q = geometry::closestPointOnTriangle(point, position[at(t[0])],
                                                        position[at(t[1])], position[at(t[2])]);
    const double d = (q - point).squaredNorm();
    if (d < minimum - 1e-15) {
      minimum = d;
      best = {q, i};
    }
  };
  tryTriangle(start);
  for (int round = 0; round < 200; ++round) {
    const int from = best.triangle;
    if (isFootInside(from, point, best.position))
      break;
    for (const int v : triangles[at(from)])
      for (const int* i = ringBegin(v); i != ringEnd(v); ++i)
        tryTriangle(*i);
    if (best.triangle == from)
      break;
  }
  return best;
}

} // namespace voluta::toolpath
