#include "layers/trim.h"

#include "base/index.h"
#include "base/mixed_bits.h"
#include "geometry/edges.h"
#include "layers/polygon_fill.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace voluta::layers {

namespace {

using Crossing = PartBoundary::Crossing;

constexpr double kShift = 1e-5;
constexpr int kSplitRounds = 4;
constexpr int kChordDepth = 6;
constexpr double kShortChord = 5e-3; // mm
constexpr double kOnSurface = 2e-3;  // mm
constexpr double kWellInside = 1e-4; // barycentric

using base::at;

std::uint64_t edgeKey(int a, int b) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::min(a, b))) << 32 |
         static_cast<std::uint32_t>(std::max(a, b));
}

// Returns a shift in [-1, 1]^3 that depends on the index alone.
Eigen::Vector3d shiftOf(std::size_t index) {
  Eigen::Vector3d s;
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint64_t h =
        base::mixedBits(index * 3 + static_cast<std::uint64_t>(axis) + 0x9e3779b97f4a7c15u);
    s[axis] = static_cast<double>(h >> 11) * 0x1p-52 - 1.0;
  }
  return s;
}

// Returns the distance of x from the line through p and q.
double lateralDistance(const Eigen::Vector3d& x, const Eigen::Vector3d& p,
                       const Eigen::Vector3d& q) {
  return (x - p).cross(q - p).norm() / (q - p).norm();
}

// 2D coordinates in the plane of a triangle.
struct PlaneFrame {
  Eigen::Vector3d origin, u, v, normal;
  PlaneFrame(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
      : origin(a), u((b - a).normalized()), normal((b - a).cross(c - a).normalized()) {
    v = normal.cross(u);
  }
  Eigen::Vector2d flat(const Eigen::Vector3d& p) const {
    return {(p - origin).dot(u), (p - origin).dot(v)};
  }
};

class Trimmer {
public:
  Trimmer(const LevelSurface& level, const PartBoundary& part, const TrimOptions& options,
          const base::RunContext& ctx)
      : s_(level), part_(part), options_(options), ctx_(ctx) {
    for (std::size_t v = 0; v < s_.surface.vertices.size(); ++v)
      s_.surface.vertices[v] += kShift * shiftOf(v);
  }

  LevelSurface run() {
    for (int round = 0; round < kSplitRounds && splitManyCrossed(); ++round) {
    }
    findCrossings();
    classify();
    cut();
    dropUnusedVertices(s_);
    return std::move(s_);
  }

private:
  struct Edge {
    int low = 0; // vertex from which crossings are measured
    std::vector<Crossing> crossings;
    int cutVertex = -1;
  };

  const Eigen::Vector3d& point(int v) const { return s_.surface.vertices[at(v)]; }

  void poll() {
    if (++polled_ % 1024 == 0)
      ctx_.checkpoint();
  }

  // Computes the crossings of all edges that may have some and were not examined yet.
  void findCrossings() {
    std::vector<Crossing> found;
    for (const auto& t : s_.surface.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = std::min(t[k], t[(k + 1) % 3]), b = std::max(t[k], t[(k + 1) % 3]);
        if (!part_.mayCross(point(a), point(b)))
          continue;
        const auto [entry, isNew] = edges_.try_emplace(edgeKey(a, b));
        if (!isNew)
          continue;
        poll();
        part_.crossings(point(a), point(b), options_.minGapMm, found);
        entry->second.low = a;
        entry->second.crossings = found;
      }
  }

  Edge* edgeOf(int a, int b) {
    const auto found = edges_.find(edgeKey(a, b));
    return found == edges_.end() ? nullptr : &found->second;
  }

  // Splits each edge that is crossed more than once, between its crossings. Returns false if there
  // was none.
  bool splitManyCrossed() {
    findCrossings();
    std::unordered_map<std::uint64_t, std::vector<int>> splits; // from the lower vertex upwards
    std::vector<std::array<int, 3>> kept, refined;
    for (const auto& t : s_.surface.triangles) {
      bool split = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        const Edge* edge = edgeOf(a, b);
        if (edge == nullptr || edge->crossings.size() < 2)
          continue;
        split = true;
        const auto [entry, isNew] = splits.try_emplace(edgeKey(a, b));
        if (isNew)
          for (std::size_t c = 0; c + 1 < edge->crossings.size(); ++c)
            entry->second.push_back(
                appendBlend(s_, std::min(a, b), std::max(a, b),
                            0.5 * (edge->crossings[c].t + edge->crossings[c + 1].t)));
      }
      if (!split) {
        kept.push_back(t);
        continue;
      }
      std::vector<int> polygon;
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        polygon.push_back(a);
        const auto entry = splits.find(edgeKey(a, b));
        if (entry == splits.end())
          continue;
        if (a < b)
          polygon.insert(polygon.end(), entry->second.begin(), entry->second.end());
        else
          polygon.insert(polygon.end(), entry->second.rbegin(), entry->second.rend());
      }
      appendFilled(t, polygon, refined);
    }
    if (splits.empty())
      return false;
    kept.insert(kept.end(), refined.begin(), refined.end());
    s_.surface.triangles.swap(kept);
    return true;
  }

  void appendFilled(const std::array<int, 3>& t, const std::vector<int>& polygon,
                    std::vector<std::array<int, 3>>& out) {
    const PlaneFrame plane(point(t[0]), point(t[1]), point(t[2]));
    flat_.clear();
    for (int v : polygon)
      flat_.push_back(plane.flat(point(v)));
    for (const auto& f : fillPolygon(flat_))
      out.push_back({polygon[at(f[0])], polygon[at(f[1])], polygon[at(f[2])]});
  }

  // Sets inside_[v] for every vertex.
  void classify() {
    const std::size_t n = s_.surface.vertices.size();
    geometry::UnionFind sets(n);
    std::vector<bool> used(n, false);
    for (const auto& t : s_.surface.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        used[at(t[k])] = true;
        const Edge* edge = edgeOf(t[k], t[(k + 1) % 3]);
        if (edge == nullptr || edge->crossings.empty())
          sets.join(t[k], t[(k + 1) % 3]);
      }
    std::vector<int> votesIn(n, 0), votesOut(n, 0);
    for (const auto& t : s_.surface.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        const Edge* edge = edgeOf(a, b);
        if (edge == nullptr || edge->crossings.size() != 1)
          continue;
        const bool highIn = edge->crossings.front().entering;
        ++(highIn ? votesIn : votesOut)[at(sets.find(std::max(a, b)))];
        ++(highIn ? votesOut : votesIn)[at(sets.find(std::min(a, b)))];
      }
    inside_.assign(n, 0);
    std::vector<signed char> answer(n, -1);
    for (std::size_t v = 0; v < n; ++v) {
      if (!used[v])
        continue;
      const std::size_t root = at(sets.find(static_cast<int>(v)));
      if (votesIn[root] > 0 && votesOut[root] > 0) {
        // With edges in a facet or a mesh with holes, the flood fill is unreliable.
        poll();
        inside_[v] = part_.inside(s_.surface.vertices[v]);
        continue;
      }
      if (answer[root] < 0) {
        if (votesIn[root] + votesOut[root] > 0)
          answer[root] = votesIn[root] > 0;
        else
          answer[root] = part_.inside(s_.surface.vertices[v]);
      }
      inside_[v] = answer[root] == 1;
    }
  }

  // Returns the vertex where edge a-b leaves the part; a and b differ in inside_.
  int cutVertex(int a, int b) {
    Edge& edge = edges_[edgeKey(a, b)];
    if (edge.cutVertex >= 0)
      return edge.cutVertex;
    const int low = std::min(a, b), high = std::max(a, b);
    double t = 0.5;
    int triangle = -1;
    if (!edge.crossings.empty()) {
      t = edge.crossings.front().t;
      triangle = edge.crossings.front().triangle;
    } else {
      double in = inside_[at(low)] ? 0.0 : 1.0, out = 1.0 - in;
      for (int step = 0; step < 24; ++step) {
        t = 0.5 * (in + out);
        (part_.inside(point(low) + t * (point(high) - point(low))) ? in : out) = t;
      }
    }
    edge.cutVertex = appendBlend(s_, low, high, t);
    facetOf_[edge.cutVertex] = triangle;
    return edge.cutVertex;
  }

  void cut() {
    std::vector<std::array<int, 3>> kept;
    const std::vector<std::array<int, 3>> triangles = std::move(s_.surface.triangles);
    for (const auto& t : triangles) {
      const int in = inside_[at(t[0])] + inside_[at(t[1])] + inside_[at(t[2])];
      if (in == 3)
        kept.push_back(t);
      if (in == 0 || in == 3)
        continue;
      poll();
      // Rotate the triangle so that the boundary runs from side (1,2) or (0,1) to side (2,0).
      std::size_t k = 0;
      while (!(in == 1 ? inside_[at(t[k])] != 0 : inside_[at(t[(k + 2) % 3])] == 0))
        ++k;
      const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      std::vector<int> polygon{a};
      if (in == 2)
        polygon.push_back(b);
      const int from = in == 1 ? cutVertex(a, b) : cutVertex(b, c), to = cutVertex(c, a);
      polygon.push_back(from);
      refineChord(t, from, to, 0, polygon);
      polygon.push_back(to);
      appendFilled(t, polygon, kept);
    }
    s_.surface.triangles = std::move(kept);
  }

  // Appends the refined boundary between vertices `from` and `to` of a triangle. The inside is to
  // its left.
  void refineChord(const std::array<int, 3>& t, int from, int to, int depth,
                   std::vector<int>& polygon) {
    const Eigen::Vector3d p = point(from), q = point(to), middle = 0.5 * (p + q);
    const double length = (q - p).norm();
    if (depth >= kChordDepth || length < kShortChord ||
        (facetOf_[from] >= 0 && facetOf_[from] == facetOf_[to]))
      return;
    const PlaneFrame plane(point(t[0]), point(t[1]), point(t[2]));
    Eigen::Vector3d x, weights;
    int facet = -1;
    // A corner close to one end of the chord leaves the chord's midpoint near the surface;
    // therefore search for corners first.
    if (!(cornerBetween(t, plane, from, to, x, weights) && (x - p).norm() < 2.0 * length &&
          (x - q).norm() < 2.0 * length && lateralDistance(x, p, q) > kShortChord)) {
      if (length < 2.0 * options_.chordMm ||
          part_.query().closest(middle, kOnSurface).triangle >= 0)
        return;
      // The bulge is measured in the triangle's plane: if the part's surface is nearly parallel to
      // it, or a wall is thin, the nearest point may be on another part of the surface.
      const double reach =
          std::max({(point(t[0]) - point(t[1])).norm(), (point(t[1]) - point(t[2])).norm(),
                    (point(t[2]) - point(t[0])).norm()});
      const Eigen::Vector3d inwards = plane.normal.cross(q - p).normalized();
      const Eigen::Vector3d a = middle - reach * inwards, b = middle + reach * inwards;
      part_.crossings(a, b, 0.0, found_);
      double nearest = 1e300;
      for (const Crossing& c : found_) {
        const double off = 2.0 * reach * std::abs(c.t - 0.5);
        if (!c.entering || off >= nearest)
          continue;
        nearest = off;
        x = a + c.t * (b - a);
        facet = c.triangle;
      }
      if (nearest <= options_.chordMm || facet < 0 || !weightsIn(t, plane, x, weights))
        return;
    }
    const int between = appendBlend(s_, t, weights, x);
    facetOf_[between] = facet;
    refineChord(t, from, between, depth + 1, polygon);
    polygon.push_back(between);
    refineChord(t, between, to, depth + 1, polygon);
  }

  // Computes the barycentric weights of a point in the triangle's plane; returns false if it is
  // outside. A corner that protrudes by less than minGapMm is moved inside.
  bool weightsIn(const std::array<int, 3>& t, const PlaneFrame& plane, Eigen::Vector3d& x,
                 Eigen::Vector3d& weights) const {
    const Eigen::Vector2d a = plane.flat(point(t[0])), b = plane.flat(point(t[1])),
                          c = plane.flat(point(t[2])), p = plane.flat(x);
    const auto area = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v,
                         const Eigen::Vector2d& w) {
      return (v.x() - u.x()) * (w.y() - u.y()) - (v.y() - u.y()) * (w.x() - u.x());
    };
    const double whole = area(a, b, c);
    weights = Eigen::Vector3d(area(p, b, c), area(a, p, c), area(a, b, p)) / whole;
    if (weights.minCoeff() > kWellInside)
      return true;
    const Eigen::Vector3d moved =
        weights.cwiseMax(kWellInside) / weights.cwiseMax(kWellInside).sum();
    const Eigen::Vector3d y =
        moved[0] * point(t[0]) + moved[1] * point(t[1]) + moved[2] * point(t[2]);
    if ((y - x).norm() > 2.0 * options_.minGapMm)
      return false;
    x = y;
    weights = moved;
    return true;
  }

  // Finds the point where a sharp edge of the part pierces the triangle: the intersection of the
  // facets at both ends of the chord with the triangle's plane.
  bool cornerBetween(const std::array<int, 3>& t, const PlaneFrame& plane, int from, int to,
                     Eigen::Vector3d& x, Eigen::Vector3d& weights) {
    const int f = facetOf_[from], g = facetOf_[to];
    if (f < 0 || g < 0 || f == g)
      return false;
    Eigen::Matrix3d m;
    m << part_.normal(f).transpose(), part_.normal(g).transpose(), plane.normal.transpose();
    if (std::abs(m.determinant()) < 0.05)
      return false;
    x = m.inverse() * Eigen::Vector3d(part_.normal(f).dot(part_.pointOf(f)),
                                      part_.normal(g).dot(part_.pointOf(g)),
                                      plane.normal.dot(plane.origin));
    return part_.query().closest(x, 1e-6).triangle >= 0 && weightsIn(t, plane, x, weights);
  }

  LevelSurface s_;
  const PartBoundary& part_;
  TrimOptions options_;
  const base::RunContext& ctx_;
  std::unordered_map<std::uint64_t, Edge> edges_;
  std::unordered_map<int, int> facetOf_; // of boundary vertices
  std::vector<std::uint8_t> inside_;
  std::vector<Eigen::Vector2d> flat_;
  std::vector<Crossing> found_;
  std::size_t polled_ = 0;
};

} // namespace

LevelSurface trimToPart(const LevelSurface& level, const PartBoundary& part,
                        const TrimOptions& options, const base::RunContext& ctx) {
  return Trimmer(level, part, options, ctx).run();
}

} // namespace voluta::layers
