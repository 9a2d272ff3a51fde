#include "regions/painting.h"

#include "geometry/append_mesh.h"
#include "geometry/edges.h"
#include "geometry/triangle_queries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::regions {

namespace {
using Eigen::Vector3d;
using geometry::TriangleMesh;

constexpr double kFinest = 0.25; // of the brush's radius: length of the sides of divided triangles

struct Piece {
  std::array<Vector3d, 3> corners;
  Vector3d middle() const { return (corners[0] + corners[1] + corners[2]) / 3.0; }
};

Piece pieceOf(const TriangleMesh& mesh, std::size_t triangle) {
  return {{mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)}};
}

void add(TriangleMesh& mesh, const Piece& piece) {
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), piece.corners.begin(), piece.corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

bool touches(const Piece& piece, const Brush& brush) {
  const auto& [a, b, c] = piece.corners;
  return (geometry::closestPointOnTriangle(brush.centre, a, b, c) - brush.centre).norm() <
         brush.radius;
}

bool isWithin(const Vector3d& place, const Brush& brush) {
  return (place - brush.centre).norm() < brush.radius;
}

// Adds the pieces of a triangle that are inside the brush, or those that are outside.
void addPieces(TriangleMesh& mesh, const Piece& piece, const Brush& brush, bool inside) {
  const auto& corners = piece.corners;
  const bool isInside =
      isWithin(corners[0], brush) && isWithin(corners[1], brush) && isWithin(corners[2], brush);
  if (isInside || !touches(piece, brush)) {
    if (isInside == inside)
      add(mesh, piece);
    return;
  }
  std::size_t longest = 0;
  double length = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    if (const double side = (corners[(k + 1) % 3] - corners[k]).norm(); side > length) {
      longest = k;
      length = side;
    }
  if (length <= kFinest * brush.radius) {
    if (isWithin(piece.middle(), brush) == inside)
      add(mesh, piece);
    return;
  }
  const Vector3d& from = corners[longest];
  const Vector3d& to = corners[(longest + 1) % 3];
  const Vector3d& other = corners[(longest + 2) % 3];
  const Vector3d half = 0.5 * (from + to);
  addPieces(mesh, {{from, half, other}}, brush, inside);
  addPieces(mesh, {{half, to, other}}, brush, inside);
}

Vector3d normalOf(const Piece& piece) {
  const auto& [a, b, c] = piece.corners;
  return (b - a).cross(c - a).normalized();
}
} // namespace

PaintableSurface::PaintableSurface(std::shared_ptr<const TriangleMesh> part)
    : part_(std::move(part)), query_(*part_, geometry::MeshQuery::Of::Surface),
      neighbours_(part_->triangles.size(), {-1, -1, -1}) {
  const std::vector<geometry::HalfEdge> sides = geometry::sortedHalfEdges(*part_);
  geometry::forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    if (end - begin != 2)
      return;
    const geometry::HalfEdge &a = sides[begin], &b = sides[begin + 1];
    neighbours_[static_cast<std::size_t>(a.triangle)][static_cast<std::size_t>(a.side)] =
        b.triangle;
    neighbours_[static_cast<std::size_t>(b.triangle)][static_cast<std::size_t>(b.side)] =
        a.triangle;
  });
}

// Returns the triangles that are reached from the first one across sides for which
// enters(from, to) holds.
template <typename Enters>
std::vector<int> PaintableSurface::connected(int first, const Enters& enters) const {
  std::vector<int> found;
  if (first < 0)
    return found;
  std::vector<bool> seen(part_->triangles.size(), false);
  found.push_back(first);
  seen[static_cast<std::size_t>(first)] = true;
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const int next : neighbours_[static_cast<std::size_t>(found[i])])
      if (next >= 0 && !seen[static_cast<std::size_t>(next)] && enters(found[i], next)) {
        seen[static_cast<std::size_t>(next)] = true;
        found.push_back(next);
      }
  return found;
}

TriangleMesh PaintableSurface::within(const Brush& brush) const {
  TriangleMesh pieces;
  const auto piece = [&](int triangle) {
    return pieceOf(*part_, static_cast<std::size_t>(triangle));
  };
  for (const int triangle : connected(query_.closest(brush.centre, brush.radius).triangle,
                                      [&](int, int to) { return touches(piece(to), brush); }))
    addPieces(pieces, piece(triangle), brush, true);
  return pieces;
}

TriangleMesh PaintableSurface::facesFrom(const Vector3d& place, double angleRad) const {
  TriangleMesh faces;
  const auto piece = [&](int triangle) {
    return pieceOf(*part_, static_cast<std::size_t>(triangle));
  };
  constexpr double kRounding = 1e-9;
  const double least = std::cos(angleRad) - kRounding;
  for (const int triangle : connected(query_.closest(place).triangle, [&](int from, int to) {
         return normalOf(piece(from)).dot(normalOf(piece(to))) >= least;
       }))
    add(faces, piece(triangle));
  return faces;
}

TriangleMesh withoutPaint(const TriangleMesh& painted, const TriangleMesh& less) {
  TriangleMesh left;
  if (less.empty())
    return painted;
  double size = 0.0;
  for (const Vector3d& v : less.vertices)
    size = std::max(size, (v - less.vertices.front()).norm());
  constexpr double kSamePlace = 1e-6; // of its size
  const geometry::MeshQuery query(less, geometry::MeshQuery::Of::Surface);
  for (std::size_t t = 0; t < painted.triangles.size(); ++t)
    if (const Piece piece = pieceOf(painted, t);
        query.closest(piece.middle(), kSamePlace * size).triangle < 0)
      add(left, piece);
  return left;
}

TriangleMesh withPaint(const TriangleMesh& painted, const TriangleMesh& more) {
  TriangleMesh all = withoutPaint(painted, more);
  geometry::appendMesh(all, more);
  return all;
}

TriangleMesh withoutPaint(const TriangleMesh& painted, const Brush& brush) {
  TriangleMesh left;
  for (std::size_t t = 0; t < painted.triangles.size(); ++t)
    addPieces(left, pieceOf(painted, t), brush, false);
  return left;
}

} // namespace voluta::regions
