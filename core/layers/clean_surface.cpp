#include "layers/clean_surface.h"

#include "base/index.h"
#include "geometry/edges.h"
#include "geometry/triangle_queries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace voluta::layers {

namespace {

constexpr int kRounds = 8;
// Shape of a triangle: 4 sqrt(3) area / sum of squared sides, 1 for an equilateral one. Triangles
// better than kGoodShape are left alone; after a collapse none may be worse than kFairShape unless
// it was worse before.
constexpr double kGoodShape = 0.4, kFairShape = 0.15;
constexpr double kWeldMm = 1e-3; // shorter edges are removed regardless of the resulting shape
constexpr double kTurned = 0.3;  // cosine: largest rotation of a triangle's normal in a collapse
constexpr double kCrease = 0.85; // cosine: edges sharper than this are not flipped

using Triangle = std::array<int, 3>;

using base::at;

Eigen::Vector3d twiceArea(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c) {
  return (b - a).cross(c - a);
}

double shapeOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return sides > 0.0 ? 2.0 * std::sqrt(3.0) * twiceArea(a, b, c).norm() / sides : 0.0;
}

// Look-up tables, rebuilt for each round from the active triangles: the triangles around each
// vertex, and the edges sorted by their lower vertex.
struct Ring {
  std::vector<geometry::HalfEdge> halfEdges;
  std::vector<int> first, triangles;       // triangles around each vertex
  std::vector<std::uint8_t> boundaryEdges; // number of boundary edges at a vertex (up to 255)
  std::vector<std::uint8_t> bad;           // 1: vertex of an edge with more than two triangles
  std::vector<std::array<int, 2>> along;   // its two boundary neighbours, if it has two

  Ring(const geometry::TriangleMesh& mesh, const std::vector<int>& active)
      : first(mesh.vertices.size() + 1, 0), triangles(3 * active.size()),
        boundaryEdges(mesh.vertices.size(), 0), bad(mesh.vertices.size(), 0),
        along(mesh.vertices.size(), {-1, -1}) {
    for (const int t : active)
      for (int v : mesh.triangles[at(t)])
        ++first[at(v) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (const int t : active)
      for (int v : mesh.triangles[at(t)])
        triangles[at(next[at(v)]++)] = t;
    halfEdges = geometry::sortedHalfEdges(mesh, active);
    geometry::forEachEdge(halfEdges, [&](std::size_t b, std::size_t e) {
      for (int v : {halfEdges[b].low, halfEdges[b].high}) {
        if (e - b > 2)
          bad[at(v)] = 1;
        if (e - b != 1)
          continue;
        if (boundaryEdges[at(v)] < 2)
          along[at(v)][boundaryEdges[at(v)]] =
              v == halfEdges[b].low ? halfEdges[b].high : halfEdges[b].low;
        if (boundaryEdges[at(v)] < 255)
          ++boundaryEdges[at(v)];
      }
    });
  }

  template <typename F> void around(int v, F&& f) const {
    for (int k = first[at(v)]; k < first[at(v) + 1]; ++k)
      f(triangles[at(k)]);
  }
};

class Cleaner {
public:
  Cleaner(LevelSurface& s, const CleanOptions& options)
      : s_(s), options_(options), afterCollapse_(s.surface.vertices.size(), 1),
        afterFlip_(afterCollapse_) {
    dropDegenerate();
  }

  // One round of collapses; returns their number.
  int collapse() {
    auto& mesh = s_.surface;
    const std::vector<std::uint8_t> mayChange = changed();
    const Ring ring(mesh, trianglesNear(mayChange, 1));
    struct Candidate {
      double length;
      int low, high;
      bool boundary;
    };
    std::vector<Candidate> candidates;
    geometry::forEachEdge(ring.halfEdges, [&](std::size_t b, std::size_t e) {
      const int low = ring.halfEdges[b].low, high = ring.halfEdges[b].high;
      if (!mayChange[at(low)] && !mayChange[at(high)])
        return;
      const double length = (point(low) - point(high)).norm();
      if (length < options_.shortEdgeMm && e - b <= 2)
        candidates.push_back({length, low, high, e - b == 1});
    });
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
      return x.length != y.length ? x.length < y.length
             : x.low != y.low     ? x.low < y.low
                                  : x.high < y.high;
    });
    std::vector<std::uint8_t>& locked = afterCollapse_;
    locked.assign(mesh.vertices.size(), 0);
    int done = 0;
    for (const Candidate& c : candidates) {
      double best = -1.0;
      int removed = -1, kept = -1;
      for (const auto& [u, v] : {std::pair{c.low, c.high}, std::pair{c.high, c.low}}) {
        const double shape = qualityOf(ring, locked, u, v, c.boundary);
        if (shape > best) {
          best = shape;
          removed = u;
          kept = v;
        }
      }
      if (removed < 0)
        continue;
      ring.around(kept, [&](int t) { lock(locked, t); });
      ring.around(removed, [&](int t) {
        lock(locked, t);
        for (int& v : mesh.triangles[at(t)])
          if (v == removed)
            v = kept;
      });
      ++done;
    }
    if (done > 0)
      dropDegenerate();
    return done;
  }

  // One round of flips; returns their number.
  int flip() {
    auto& mesh = s_.surface;
    const std::vector<std::uint8_t> mayChange = changed();
    const Ring ring(mesh, trianglesNear(mayChange, 2));
    std::vector<std::uint8_t>& locked = afterFlip_;
    locked.assign(mesh.vertices.size(), 0);
    int done = 0;
    geometry::forEachEdge(ring.halfEdges, [&](std::size_t b, std::size_t e) {
      if (e - b != 2 || ring.halfEdges[b].forward == ring.halfEdges[b + 1].forward)
        return;
      const geometry::HalfEdge& h =
          ring.halfEdges[b].forward ? ring.halfEdges[b] : ring.halfEdges[b + 1];
      const geometry::HalfEdge& g =
          ring.halfEdges[b].forward ? ring.halfEdges[b + 1] : ring.halfEdges[b];
      Triangle &s = mesh.triangles[at(h.triangle)], &t = mesh.triangles[at(g.triangle)];
      const int u = h.low, v = h.high; // s holds u -> v, t holds v -> u
      const int x = s[at((h.side + 2) % 3)], y = t[at((g.side + 2) % 3)];
      if (!mayChange[at(u)] && !mayChange[at(v)] && !mayChange[at(x)] && !mayChange[at(y)])
        return;
      if (x == y || locked[at(u)] || locked[at(v)] || locked[at(x)] || locked[at(y)])
        return;
      const Eigen::Vector3d &pu = point(u), &pv = point(v), &px = point(x), &py = point(y);
      const double before = std::min(shapeOf(pu, pv, px), shapeOf(pv, pu, py));
      if (before > kGoodShape)
        return;
      const double after = std::min(shapeOf(px, py, pv), shapeOf(py, px, pu));
      if (after < 1.2 * before + 1e-6)
        return;
      const Eigen::Vector3d whole = twiceArea(pu, pv, px) + twiceArea(pv, pu, py);
      const Eigen::Vector3d n1 = twiceArea(px, py, pv), n2 = twiceArea(py, px, pu);
      const double size = whole.norm();
      if (n1.dot(whole) < kCrease * n1.norm() * size || n2.dot(whole) < kCrease * n2.norm() * size)
        return;
      bool joined = false;
      ring.around(x, [&](int k) {
        for (int w : mesh.triangles[at(k)])
          joined |= w == y;
      });
      if (joined)
        return;
      s = {x, y, v};
      t = {y, x, u};
      for (int w : {u, v, x, y})
        locked[at(w)] = 1;
      ++done;
    });
    return done;
  }

private:
  // Returns the vertices that were changed, or locked by a neighbouring change, since the last
  // round of the kind: elsewhere the result would be the same again.
  std::vector<std::uint8_t> changed() const {
    std::vector<std::uint8_t> mask(afterCollapse_);
    for (std::size_t v = 0; v < mask.size(); ++v)
      mask[v] |= afterFlip_[v];
    return mask;
  }

  // Returns all triangles around vertices within this number of edges from the set.
  std::vector<int> trianglesNear(std::vector<std::uint8_t> near, int edges) const {
    const auto& triangles = s_.surface.triangles;
    const auto touches = [&](const Triangle& t) {
      return near[at(t[0])] != 0 || near[at(t[1])] != 0 || near[at(t[2])] != 0;
    };
    for (; edges > 0; --edges) {
      std::vector<std::uint8_t> wider(near);
      for (const Triangle& t : triangles)
        if (touches(t))
          wider[at(t[0])] = wider[at(t[1])] = wider[at(t[2])] = 1;
      near.swap(wider);
    }
    std::vector<int> found;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (touches(triangles[t]))
        found.push_back(static_cast<int>(t));
    return found;
  }

  const Eigen::Vector3d& point(int v) const { return s_.surface.vertices[at(v)]; }

  void lock(std::vector<std::uint8_t>& locked, int triangle) const {
    for (int v : s_.surface.triangles[at(triangle)])
      locked[at(v)] = 1;
  }

  // Returns the worst shape after moving u onto v; -1 if that is not allowed.
  double qualityOf(const Ring& ring, const std::vector<std::uint8_t>& locked, int u, int v,
                   bool boundaryEdge) const {
    if (locked[at(u)] || locked[at(v)] || ring.bad[at(u)] || ring.bad[at(v)])
      return -1.0;
    const int boundaryAtU = ring.boundaryEdges[at(u)];
    if (boundaryAtU > 2 || ring.boundaryEdges[at(v)] > 2)
      return -1.0;
    if (boundaryAtU > 0) {
      if (!boundaryEdge)
        return -1.0;
      const auto& along = ring.along[at(u)];
      const int other = along[0] == v ? along[1] : along[0];
      if (other < 0 || other == v ||
          geometry::distanceToSegment(point(u), point(other), point(v)) >
              options_.boundaryToleranceMm)
        return -1.0;
    }
    // Link condition: u and v must share no neighbours except those opposite their edge.
    int shared = 0, edgeTriangles = 0;
    neighbours_.clear();
    ring.around(v, [&](int t) {
      for (int w : s_.surface.triangles[at(t)])
        if (w != v)
          neighbours_.push_back(w);
    });
    std::sort(neighbours_.begin(), neighbours_.end());
    mine_.clear();
    double worst = 1.0, worstBefore = 1.0;
    bool turned = false;
    ring.around(u, [&](int t) {
      const Triangle& tri = s_.surface.triangles[at(t)];
      bool hasV = false;
      for (int w : tri) {
        if (w == v)
          hasV = true;
        else if (w != u)
          mine_.push_back(w);
      }
      std::array<Eigen::Vector3d, 3> p = {point(tri[0]), point(tri[1]), point(tri[2])};
      worstBefore = std::min(worstBefore, shapeOf(p[0], p[1], p[2]));
      if (hasV) {
        ++edgeTriangles;
        return;
      }
      const Eigen::Vector3d before = twiceArea(p[0], p[1], p[2]);
      for (std::size_t k = 0; k < 3; ++k)
        if (tri[k] == u)
          p[k] = point(v);
      const Eigen::Vector3d after = twiceArea(p[0], p[1], p[2]);
      turned |= after.dot(before) < kTurned * after.norm() * before.norm() || after.norm() < 1e-12;
      worst = std::min(worst, shapeOf(p[0], p[1], p[2]));
    });
    const bool weld = (point(u) - point(v)).norm() < kWeldMm;
    if ((turned && !weld) || edgeTriangles != (boundaryEdge ? 1 : 2))
      return -1.0;
    std::sort(mine_.begin(), mine_.end());
    mine_.erase(std::unique(mine_.begin(), mine_.end()), mine_.end());
    for (int w : mine_)
      shared += std::binary_search(neighbours_.begin(), neighbours_.end(), w) ? 1 : 0;
    if (shared != edgeTriangles)
      return -1.0;
    if (!weld && worst < kFairShape && worst < worstBefore)
      return -1.0;
    return worst;
  }

  void dropDegenerate() {
    auto& triangles = s_.surface.triangles;
    std::erase_if(triangles,
                  [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  }

  LevelSurface& s_;
  CleanOptions options_;
  // vertices locked by the last round of each kind
  std::vector<std::uint8_t> afterCollapse_, afterFlip_;
  mutable std::vector<int> neighbours_, mine_;
};

} // namespace

void cleanSurface(LevelSurface& surface, const CleanOptions& options, const base::RunContext& ctx) {
  Cleaner cleaner(surface, options);
  for (int round = 0; round < kRounds; ++round) {
    ctx.checkpoint();
    const int collapsed = cleaner.collapse();
    const int flipped = options.flipEdges ? cleaner.flip() : 0;
    if (collapsed + flipped == 0)
      break;
  }
  dropUnusedVertices(surface);
}

} // namespace voluta::layers
