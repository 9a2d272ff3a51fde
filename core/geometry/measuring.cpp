#include "geometry/measuring.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/edges.h"
#include "geometry/measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

namespace voluta::geometry {

namespace {

using Eigen::Vector3d;

const double kEdgeCos = std::cos(base::degreesToRadians(20.0));
const double kParallelCos = std::cos(base::degreesToRadians(0.5));
// Facets of one round face, sides of one round edge.
const double kSmoothCos = std::cos(base::degreesToRadians(35.0));
const double kFlatCos = std::cos(base::degreesToRadians(0.2));
constexpr std::size_t kMinFacets = 3;

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vector3d nearestOn(const Vector3d& a, const Vector3d& b, const Vector3d& p) {
  const Vector3d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return a + t * along;
}

// Returns whether the facets face in at least three directions, of a sphere not all in one plane.
bool isBent(RoundShape::Of of, const std::vector<int>& triangles,
            const std::vector<Vector3d>& normals) {
  std::vector<Vector3d> distinct;
  for (const int t : triangles) {
    const Vector3d& normal = normals[static_cast<std::size_t>(t)];
    if (std::ranges::any_of(distinct,
                            [&](const Vector3d& known) { return known.dot(normal) > kFlatCos; }))
      continue;
    distinct.push_back(normal);
    if (distinct.size() < kMinFacets)
      continue;
    if (of == RoundShape::Of::Cylinder)
      return true;
    constexpr double kOutOfPlane = 0.02; // sine
    const Vector3d plane = distinct[0].cross(distinct[1]).normalized();
    if (std::abs(plane.dot(normal)) > kOutOfPlane)
      return true;
  }
  return false;
}

} // namespace

MeasuredPair measuredPair(const MeasuredPoint& from, const MeasuredPoint& to) {
  using On = MeasuredPoint::On;
  MeasuredPair pair;
  pair.alongAxesMm = to.point - from.point;
  pair.distanceMm = pair.alongAxesMm.norm();
  if (from.on == On::Corner || to.on == On::Corner)
    return pair;
  const double angle = angleBetween(from.direction, to.direction);
  const double lines = std::min(angle, base::kPi - angle);
  if (from.on == On::Face && to.on == On::Face) {
    const bool areParallel = std::abs(from.direction.dot(to.direction)) > kParallelCos;
    pair.angleRad = areParallel ? 0.0 : base::kPi - angle;
    if (areParallel)
      pair.planesMm = std::abs(pair.alongAxesMm.dot(from.direction));
  } else {
    pair.angleRad = from.on == to.on ? lines : 0.5 * base::kPi - lines;
  }
  return pair;
}

Measuring::Measuring(TriangleMesh mesh)
    : mesh_(std::move(mesh)), query_(mesh_, MeshQuery::Of::Surface) {
  base::require(!mesh_.empty(), "Measuring: a mesh with triangles");
  diagonalMm_ = bounds(mesh_).diagonal().norm();
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
    normals_.push_back((mesh_.corner(t, 1) - mesh_.corner(t, 0))
                           .cross(mesh_.corner(t, 2) - mesh_.corner(t, 0))
                           .normalized());
  findEdges();
  findCorners();
}

const Vector3d& Measuring::vertex(int index) const {
  return mesh_.vertices[static_cast<std::size_t>(index)];
}

void Measuring::findEdges() {
  neighbours_.assign(mesh_.triangles.size(), {-1, -1, -1});
  edgesAt_.resize(mesh_.vertices.size());
  const std::vector<HalfEdge> sides = sortedHalfEdges(mesh_);
  forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    const HalfEdge &a = sides[begin], &b = sides[end - 1];
    const auto first = static_cast<std::size_t>(a.triangle),
               second = static_cast<std::size_t>(b.triangle);
    bool isSharp = end - begin != 2;
    if (!isSharp) {
      neighbours_[first][static_cast<std::size_t>(a.side)] = b.triangle;
      neighbours_[second][static_cast<std::size_t>(b.side)] = a.triangle;
      isSharp = normals_[first].dot(normals_[second]) < kEdgeCos;
    }
    if (!isSharp)
      return;
    const int edge = static_cast<int>(edges_.size());
    edges_.push_back({a.low, a.high});
    edgesAt_[static_cast<std::size_t>(a.low)].push_back(edge);
    edgesAt_[static_cast<std::size_t>(a.high)].push_back(edge);
  });
}

void Measuring::findCorners() {
  for (std::size_t v = 0; v < edgesAt_.size(); ++v) {
    const std::vector<int>& edges = edgesAt_[v];
    if (edges.empty())
      continue;
    bool isCorner = edges.size() != 2;
    if (!isCorner) {
      const auto away = [&](int e) -> Vector3d {
        const Edge& edge = edges_[static_cast<std::size_t>(e)];
        const int other = edge.from == static_cast<int>(v) ? edge.to : edge.from;
        return (vertex(other) - mesh_.vertices[v]).normalized();
      };
      isCorner = -away(edges[0]).dot(away(edges[1])) < kEdgeCos;
    }
    if (isCorner)
      corners_.push_back(static_cast<int>(v));
  }
}

std::optional<MeasuredPoint> Measuring::snapped(const Vector3d& point, double snapMm) const {
  MeasuredPoint found;
  double nearest = snapMm;
  int corner = -1, edge = -1;
  for (const int v : corners_)
    if (const double d = (vertex(v) - point).norm(); d <= nearest) {
      nearest = d;
      corner = v;
    }
  if (corner >= 0) {
    found.on = MeasuredPoint::On::Corner;
    found.point = vertex(corner);
    return found;
  }
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Vector3d on = nearestOn(vertex(edges_[e].from), vertex(edges_[e].to), point);
    if (const double d = (on - point).norm(); d <= nearest) {
      nearest = d;
      edge = static_cast<int>(e);
      found.point = on;
    }
  }
  if (edge < 0)
    return std::nullopt;
  const Edge& of = edges_[static_cast<std::size_t>(edge)];
  found.on = MeasuredPoint::On::Edge;
  found.direction = (vertex(of.to) - vertex(of.from)).normalized();
  found.round = roundEdge(edge);
  return found;
}

MeasuredPoint Measuring::at(const Vector3d& point, double snapMm) const {
  const MeshQuery::Closest closest = query_.closest(point);
  if (auto found = snapped(closest.point, snapMm))
    return *found;
  MeasuredPoint found;
  found.point = closest.point;
  found.direction = normals_[static_cast<std::size_t>(closest.triangle)];
  found.round = roundFace(closest.triangle);
  found.wallMm = wallMm(closest.point, closest.triangle);
  return found;
}

std::optional<double> Measuring::wallMm(const Vector3d& point, int triangle) const {
  constexpr double kSkinShare = 1e-7; // of the part: behind the face itself
  const Vector3d in = -normals_[static_cast<std::size_t>(triangle)];
  if (in.isZero())
    return std::nullopt;
  const double skip = kSkinShare * diagonalMm_;
  const Vector3d from = point + skip * in, to = point + 1.01 * diagonalMm_ * in;
  const auto hit = query_.firstHit(from, to);
  if (!hit)
    return std::nullopt;
  return skip + hit->t * (to - from).norm();
}

// Returns the vertices that follow `via` on smoothly continued edges, `fromVertex` and `via` first.
std::vector<Vector3d> Measuring::chainOf(int edge, int fromVertex, int via) const {
  std::vector<Vector3d> chain{vertex(fromVertex), vertex(via)};
  std::set<int> used{edge};
  for (int from = fromVertex, at = via;;) {
    const Vector3d along = (vertex(at) - vertex(from)).normalized();
    int next = -1, on = -1;
    double straightest = kSmoothCos;
    for (const int e : edgesAt_[static_cast<std::size_t>(at)]) {
      const Edge& candidate = edges_[static_cast<std::size_t>(e)];
      const int other = candidate.from == at ? candidate.to : candidate.from;
      const double turn = (vertex(other) - vertex(at)).normalized().dot(along);
      if (!used.contains(e) && turn > straightest) {
        straightest = turn;
        next = other;
        on = e;
      }
    }
    if (next < 0)
      return chain;
    used.insert(on);
    chain.push_back(vertex(next));
    from = at;
    at = next;
  }
}

// The edge and its two neighbours in succession determine the circle, in three ways.
std::optional<RoundShape> Measuring::roundEdge(int edge) const {
  const Edge& of = edges_[static_cast<std::size_t>(edge)];
  const std::vector<Vector3d> ahead = chainOf(edge, of.from, of.to);
  const std::vector<Vector3d> back = chainOf(edge, of.to, of.from);
  std::vector<Vector3d> chain(back.rbegin(), back.rend());
  chain.insert(chain.end(), ahead.begin() + 2, ahead.end());
  const std::size_t at = back.size() - 2; // the edge runs from there to the next
  std::optional<RoundShape> best;
  std::size_t most = kMinFacets; // vertices; a circle through three proves nothing
  for (std::size_t from = at >= 1 ? at - 1 : 0; from <= at && from + 2 < chain.size(); ++from) {
    const auto circle = circleThrough(chain[from], chain[from + 1], chain[from + 2]);
    if (!circle)
      continue;
    std::size_t low = from, high = from + 2;
    while (low > 0 && isOn(*circle, chain[low - 1]))
      --low;
    while (high + 1 < chain.size() && isOn(*circle, chain[high + 1]))
      ++high;
    if (high - low + 1 <= most)
      continue;
    most = high - low + 1;
    // Points far from each other determine it best; the ends of a closed chain are one.
    best =
        circleThrough(chain[low], chain[low + (high - low) / 3], chain[low + 2 * (high - low) / 3])
            .value_or(*circle);
  }
  return best;
}

// Facets in succession on a round face, which bends but has no edge between them.
bool Measuring::isCurvedStep(int from, int to) const {
  return to >= 0 && normals_[static_cast<std::size_t>(from)].dot(
                        normals_[static_cast<std::size_t>(to)]) > kSmoothCos;
}

template <class Fits> std::vector<int> Measuring::grown(int triangle, const Fits& fits) const {
  std::set<int> found{triangle};
  std::vector<int> order{triangle};
  for (std::size_t i = 0; i < order.size(); ++i)
    for (const int next : neighbours_[static_cast<std::size_t>(order[i])])
      if (next >= 0 && !found.contains(next) && fits(order[i], next)) {
        found.insert(next);
        order.push_back(next);
      }
  return order;
}

std::vector<int> Measuring::flatAround(int triangle) const {
  const Vector3d& normal = normals_[static_cast<std::size_t>(triangle)];
  return grown(triangle, [&](int, int next) {
    return normals_[static_cast<std::size_t>(next)].dot(normal) > kFlatCos;
  });
}

std::optional<RoundShape> Measuring::roundFace(int triangle) const {
  const std::vector<int> flat = flatAround(triangle);
  constexpr std::size_t kMaxOfFacet = 400; // A flat face of more triangles is no facet
  if (flat.size() > kMaxOfFacet)
    return std::nullopt;
  const auto cornersOf = [&](const std::vector<int>& triangles) {
    std::vector<Vector3d> points;
    for (const int t : triangles)
      for (int k = 0; k < 3; ++k)
        points.push_back(mesh_.corner(static_cast<std::size_t>(t), k));
    return points;
  };
  // Candidates: what the facet and one beside it, or all beside it, determine.
  std::vector<RoundShape> candidates;
  const Vector3d& normal = normals_[static_cast<std::size_t>(triangle)];
  std::vector<Vector3d> around = cornersOf(flat);
  std::set<int> beside;
  for (const int t : flat)
    for (const int next : neighbours_[static_cast<std::size_t>(t)])
      if (isCurvedStep(t, next) && normals_[static_cast<std::size_t>(next)].dot(normal) <= kFlatCos)
        beside.insert(next);
  for (const int next : beside) {
    std::vector<Vector3d> points = cornersOf(flat);
    const std::vector<Vector3d> more = cornersOf(flatAround(next));
    points.insert(points.end(), more.begin(), more.end());
    const Vector3d axis = normal.cross(normals_[static_cast<std::size_t>(next)]).normalized();
    if (const auto cylinder = cylinderThrough(points, axis))
      candidates.push_back(*cylinder);
    const std::vector<Vector3d> own = cornersOf({next});
    around.insert(around.end(), own.begin(), own.end());
  }
  if (const auto sphere = sphereThrough(around))
    candidates.push_back(*sphere);
  std::optional<RoundShape> best;
  std::size_t most = 0;
  for (const RoundShape& candidate : candidates) {
    const std::vector<int> on = grown(triangle, [&](int from, int next) {
      const auto t = static_cast<std::size_t>(next);
      return isCurvedStep(from, next) &&
             isFacetOf(candidate, {mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)},
                       normals_[t]);
    });
    if (on.size() <= most || !isBent(candidate.of, on, normals_))
      continue;
    most = on.size();
    best = refined(candidate, cornersOf(on));
  }
  if (best && best->of == RoundShape::Of::Cylinder) {
    const Vector3d middle = mesh_.corner(static_cast<std::size_t>(triangle), 0);
    best->centre += (middle - best->centre).dot(best->axis) * best->axis;
  }
  return best;
}

} // namespace voluta::geometry
