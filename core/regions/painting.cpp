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

std::size_t longestSide(const Piece& piece) {
  std::size_t longest = 0;
  double length = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    if (const double side = (piece.corners[(k + 1) % 3] - piece.corners[k]).norm(); side > length) {
      longest = k;
      length = side;
    }
  return longest;
}

// Returns whether a piece is not divided any more.
bool isFine(const Piece& piece, const Brush& brush) {
  const std::size_t longest = longestSide(piece);
  return (piece.corners[(longest + 1) % 3] - piece.corners[longest]).norm() <=
         kFinest * brush.radius;
}

// Returns the halves of a piece, across its longest side.
std::array<Piece, 2> halves(const Piece& piece) {
  const std::size_t longest = longestSide(piece);
  const Vector3d& from = piece.corners[longest];
  const Vector3d& to = piece.corners[(longest + 1) % 3];
  const Vector3d& other = piece.corners[(longest + 2) % 3];
  const Vector3d half = 0.5 * (from + to);
  return {Piece{{from, half, other}}, Piece{{half, to, other}}};
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
  if (isFine(piece, brush)) {
    if (isWithin(piece.middle(), brush) == inside)
      add(mesh, piece);
    return;
  }
  for (const Piece& half : halves(piece))
    addPieces(mesh, half, brush, inside);
}

// A surface that covers others on the same part.
class Cover {
public:
  explicit Cover(const TriangleMesh& mesh) : query_(mesh, geometry::MeshQuery::Of::Surface) {
    for (const Vector3d& v : mesh.vertices)
      box_.extend(v);
    constexpr double kSamePlace = 1e-6; // of its size
    same_ = kSamePlace * box_.diagonal().norm();
    box_.min().array() -= same_;
    box_.max().array() += same_;
  }

  bool covers(const Vector3d& place) const {
    return box_.contains(place) && query_.closest(place, same_).triangle >= 0;
  }
  bool mayTouch(const Piece& piece) const {
    Eigen::AlignedBox3d box;
    for (const Vector3d& corner : piece.corners)
      box.extend(corner);
    return box_.intersects(box);
  }

private:
  geometry::MeshQuery query_;
  Eigen::AlignedBox3d box_;
  double same_ = 0.0;
};

// Adds the pieces of a triangle that are not covered; returns whether it is all of it, which is
// then one piece.
bool addUncovered(TriangleMesh& mesh, const Piece& piece, const Cover& cover, const Brush& brush) {
  if (!cover.mayTouch(piece) || !touches(piece, brush)) {
    add(mesh, piece);
    return true;
  }
  if (isFine(piece, brush)) {
    const bool isLeft = !cover.covers(piece.middle());
    if (isLeft)
      add(mesh, piece);
    return isLeft;
  }
  const std::size_t vertices = mesh.vertices.size(), triangles = mesh.triangles.size();
  bool isWhole = true;
  for (const Piece& half : halves(piece))
    isWhole = addUncovered(mesh, half, cover, brush) && isWhole;
  if (isWhole) {
    mesh.vertices.resize(vertices);
    mesh.triangles.resize(triangles);
    add(mesh, piece);
  }
  return isWhole;
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
  const Cover cover(less);
  for (std::size_t t = 0; t < painted.triangles.size(); ++t)
    if (const Piece piece = pieceOf(painted, t); !cover.covers(piece.middle()))
      add(left, piece);
  return left;
}

TriangleMesh withPaint(const TriangleMesh& painted, const TriangleMesh& more) {
  TriangleMesh all = withoutPaint(painted, more);
  geometry::appendMesh(all, more);
  return all;
}

TriangleMesh withPaint(const TriangleMesh& painted, const TriangleMesh& more, const Brush& brush) {
  if (more.empty())
    return painted;
  TriangleMesh all;
  const Cover cover(more);
  for (std::size_t t = 0; t < painted.triangles.size(); ++t)
    addUncovered(all, pieceOf(painted, t), cover, brush);
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
