#include "geometry/repair/surface_wall.h"

#include "base/error.h"
#include "base/index.h"
#include "geometry/append_mesh.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/repair/orientation.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/repair/self_intersections.h"
#include "geometry/repair/sheets.h"
#include "geometry/repair/winding_union.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace voluta::geometry {

namespace {
using base::at;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Weight of the smallest move against the planes of the triangles.
constexpr double kSmallMove = 1e-4;
// A vertex moves by at most this many times the move across its triangles: limits sharp edges.
constexpr double kMiter = 2.0;
// Horizontal part of the normal from which moves are parallel to the plate, and up to which they
// have no preferred direction; weight of moves along `up` against the others.
constexpr double kSteep = 0.5, kShallow = 0.2, kUpWeight = 100.0;

// `text` has placeholders for a count and three coordinates.
[[noreturn]] void refuse(base::Text text, std::size_t count, const Vector3d& place) {
  throw base::Error(
      base::ErrorCode::UnusableInput,
      base::Message(
          text, {count, base::number(place.x()), base::number(place.y()), base::number(place.z())}),
      {},
      "thicken it to a wall of two beads (`openSurfaces=thicken`), or repair it in a modelling "
      "program"_text);
}

// Keeps one of the triangles with the same corners.
void dropRepeated(TriangleMesh& mesh) {
  std::set<std::array<int, 3>> seen;
  std::erase_if(mesh.triangles, [&](std::array<int, 3> t) {
    std::ranges::sort(t);
    return !seen.insert(t).second;
  });
}

// Throws if an edge has more than two triangles, or two that disagree.
void requireTwoSides(const TriangleMesh& sheets) {
  std::size_t branches = 0, oneSided = 0;
  std::optional<Vector3d> branch, twist;
  const std::vector<HalfEdge> edges = sortedHalfEdges(sheets);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    const Vector3d middle =
        0.5 * (sheets.vertices[at(edges[begin].low)] + sheets.vertices[at(edges[begin].high)]);
    if (end - begin > 2) {
      ++branches;
      branch = branch.value_or(middle);
    } else if (end - begin == 2 && edges[begin].forward == edges[begin + 1].forward) {
      ++oneSided;
      twist = twist.value_or(middle);
    }
  });
  if (branch)
    refuse(
        "the open surface branches at {edges} edges, the first at ({x:.4g}, {y:.4g}, {z:.4g})"_text,
        branches, *branch);
  if (twist)
    refuse("the open surface has only one side: it is twisted along {edges} edges, the first at "
           "({x:.4g}, {y:.4g}, {z:.4g})"_text,
           oneSided, *twist);
}

void requireNoCrossing(const TriangleMesh& sheets, const TriangleMesh& solids,
                       const base::RunContext& ctx) {
  TriangleMesh all = sheets;
  appendMesh(all, solids);
  const auto pairs = selfIntersections(all, ctx);
  if (pairs.empty())
    return;
  const auto t = at(pairs.front().first);
  refuse("the open surface crosses itself at {places} pairs of triangles, the first at ({x:.4g}, "
         "{y:.4g}, {z:.4g})"_text,
         pairs.size(), (all.corner(t, 0) + all.corner(t, 1) + all.corner(t, 2)) / 3.0);
}

void closeSmallHoles(TriangleMesh& sheets, double widest, const base::RunContext& ctx) {
  for (const RimCap& cap : rimCaps(sheets, ctx)) {
    Eigen::AlignedBox3d box;
    for (const int v : cap.rim)
      box.extend(sheets.vertices[at(v)]);
    if (box.diagonal().norm() < widest)
      sheets.triangles.insert(sheets.triangles.end(), cap.triangles.begin(), cap.triangles.end());
  }
}

// The planes of the triangles around a vertex.
struct VertexPlanes {
  Matrix3d normals = Matrix3d::Zero(); // sum of weight n n^T
  Vector3d moves = Vector3d::Zero();   // sum of weight move n
  Vector3d mean = Vector3d::Zero();    // sum of weight n
  double weight = 0.0, maximum = 0.0;  // maximum: the largest move

  void add(const Vector3d& normal, double move, double w) {
    normals += w * normal * normal.transpose();
    moves += w * move * normal;
    mean += w * normal;
    weight += w;
    maximum = std::max(maximum, move);
  }

  // Returns the move onto the planes, by least squares.
  Vector3d move(const Vector3d& up) const {
    const double length = mean.norm();
    if (!(weight > 0.0) || !(length > 0.0))
      return Vector3d::Zero();
    const Vector3d n = mean / length;
    const double level =
        std::clamp((n.cross(up).norm() - kShallow) / (kSteep - kShallow), 0.0, 1.0);
    const double upWeight = 1.0 + (kUpWeight - 1.0) * level * level;
    const Matrix3d alongUp = up * up.transpose();
    const Matrix3d cheap = Matrix3d::Identity() - (1.0 - 1.0 / upWeight) * alongUp;
    const Matrix3d costs = Matrix3d::Identity() + (upWeight - 1.0) * alongUp;
    const Matrix3d system = normals / weight + kSmallMove * n.dot(cheap * n) * costs;
    Vector3d moved = system.inverse() * (moves / weight);
    const double limit = kMiter * maximum / std::max(kShallow, std::sqrt(n.dot(cheap * n)));
    if (const double far = moved.norm(); far > limit)
      moved *= limit / far;
    return moved;
  }
};

std::vector<Vector3d> movesOf(const TriangleMesh& sheets, const WallShape& shape) {
  std::vector<VertexPlanes> planes(sheets.vertices.size());
  for (std::size_t t = 0; t < sheets.triangles.size(); ++t) {
    const Vector3d normal = triangleNormal(sheets, t);
    for (int k = 0; k < 3; ++k) {
      const Vector3d a = sheets.corner(t, (k + 1) % 3) - sheets.corner(t, k),
                     b = sheets.corner(t, (k + 2) % 3) - sheets.corner(t, k);
      planes[at(sheets.triangles[t][at(k)])].add(normal, 0.5 * shape.across(normal),
                                                 std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  }
  std::vector<Vector3d> moves;
  moves.reserve(planes.size());
  for (const VertexPlanes& p : planes)
    moves.push_back(p.move(shape.up));
  return moves;
}

// Both sides of the surface, joined along its rims.
TriangleMesh bothSides(const TriangleMesh& sheets, const std::vector<Vector3d>& moves) {
  TriangleMesh wall;
  const int n = static_cast<int>(sheets.vertices.size());
  for (const double side : {1.0, -1.0})
    for (std::size_t v = 0; v < moves.size(); ++v)
      wall.vertices.emplace_back(sheets.vertices[v] + side * moves[v]);
  wall.triangles = sheets.triangles;
  for (const auto& t : sheets.triangles)
    wall.triangles.push_back({t[0] + n, t[2] + n, t[1] + n});
  const std::vector<HalfEdge> edges = sortedHalfEdges(sheets);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    if (end - begin != 1)
      return;
    const HalfEdge& e = edges[begin];
    const int from = e.forward ? e.low : e.high, to = e.forward ? e.high : e.low;
    wall.triangles.push_back({to, from, from + n});
    wall.triangles.push_back({to, from + n, to + n});
  });
  return wall;
}
} // namespace

double WallShape::across(const Vector3d& normal) const {
  if (layerHeight <= 0.0)
    return width;
  const double vertical = std::min(1.0, std::abs(normal.dot(up)));
  return std::max(width * std::sqrt(1.0 - vertical * vertical), layerHeight * vertical);
}

TriangleMesh surfaceWall(const TriangleMesh& mesh, const WallShape& shape,
                         const base::RunContext& ctx) {
  base::require(shape.width > 0.0, "surfaceWall: width > 0");
  auto [solids, sheets] = separateSolids(mesh);
  dropCollapsedFaces(sheets);
  dropRepeated(sheets);
  if (sheets.empty())
    return std::move(solids);
  orientConsistently(sheets);
  requireTwoSides(sheets);
  ctx.checkpoint();
  requireNoCrossing(sheets, solids, ctx);
  closeSmallHoles(sheets, shape.width, ctx);
  ctx.checkpoint();
  appendMesh(solids, bothSides(sheets, movesOf(sheets, shape)));
  return overlapsUnited(std::move(solids), ctx);
}

} // namespace voluta::geometry
