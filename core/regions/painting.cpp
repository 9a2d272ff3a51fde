#include "regions/painting.h"

#include "geometry/append_mesh.h"
#include "geometry/edges.h"
#include "geometry/triangle_queries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
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
bool isFine(const Piece& piece, double finest) {
  const std::size_t longest = longestSide(piece);
  return (piece.corners[(longest + 1) % 3] - piece.corners[longest]).norm() <= finest;
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
  if (isFine(piece, finestOf(brush))) {
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
bool addUncovered(TriangleMesh& mesh, const Piece& piece, const Cover& cover, double finest) {
  if (!cover.mayTouch(piece)) {
    add(mesh, piece);
    return true;
  }
  if (isFine(piece, finest)) {
    const bool isLeft = !cover.covers(piece.middle());
    if (isLeft)
      add(mesh, piece);
    return isLeft;
  }
  const std::size_t vertices = mesh.vertices.size(), triangles = mesh.triangles.size();
  bool isWhole = true;
  for (const Piece& half : halves(piece))
    isWhole = addUncovered(mesh, half, cover, finest) && isWhole;
  if (isWhole) {
    mesh.vertices.resize(vertices);
    mesh.triangles.resize(triangles);
    add(mesh, piece);
  }
  return isWhole;
}

// Returns a convex polygon without its part behind a plane through a point.
std::vector<Vector3d> cutOff(const std::vector<Vector3d>& polygon, const Vector3d& inward,
                             const Vector3d& through) {
  std::vector<Vector3d> left;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector3d &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double inA = inward.dot(a - through), inB = inward.dot(b - through);
    if (inA >= 0.0)
      left.push_back(a);
    if ((inA >= 0.0) != (inB >= 0.0))
      left.push_back(a + inA / (inA - inB) * (b - a));
  }
  return left;
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

TriangleMesh PaintableSurface::seen(const SeenThrough& through, double finest) const {
  std::array<Vector3d, 4> inward;
  const Vector3d ahead =
      through.corners[0] + through.corners[1] + through.corners[2] + through.corners[3];
  for (std::size_t k = 0; k < 4; ++k) {
    inward[k] = through.corners[k].cross(through.corners[(k + 1) % 4]).normalized();
    if (inward[k].dot(ahead) < 0.0)
      inward[k] = -inward[k];
  }
  constexpr double kClear = 1e-4; // of the way to the eye, to leave the surface
  const auto isSeen = [&](const Vector3d& place) {
    return !query_.firstHit(place + kClear * (through.eye - place), through.eye);
  };
  TriangleMesh mesh;
  // Corners belong to other triangles too: places a little inside are asked.
  const std::function<void(const Piece&)> addSeen = [&](const Piece& piece) {
    constexpr double kInside = 0.05;
    const Vector3d middle = piece.middle();
    int seen = isSeen(middle) ? 1 : 0;
    const bool middleSeen = seen > 0;
    for (const Vector3d& corner : piece.corners)
      seen += isSeen(corner + kInside * (middle - corner)) ? 1 : 0;
    constexpr double kCoarse = 8.0; // what hides a part of a larger piece may be between the places
    const bool isSame = seen == 0 || seen == 4;
    if (isSame ? isFine(piece, kCoarse * finest) : isFine(piece, finest)) {
      if (middleSeen)
        add(mesh, piece);
      return;
    }
    for (const Piece& half : halves(piece))
      addSeen(half);
  };
  for (std::size_t t = 0; t < part_->triangles.size(); ++t) {
    const Piece whole = pieceOf(*part_, t);
    if (normalOf(whole).dot(through.eye - whole.middle()) <= 0.0)
      continue;
    std::vector<Vector3d> corners(whole.corners.begin(), whole.corners.end());
    for (const Vector3d& side : inward)
      corners = cutOff(corners, side, through.eye);
    for (std::size_t k = 2; k < corners.size(); ++k)
      addSeen({{corners[0], corners[k - 1], corners[k]}});
  }
  return mesh;
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

TriangleMesh withPaint(const TriangleMesh& painted, const TriangleMesh& more, double finest) {
  TriangleMesh all = withoutPaint(painted, more, finest);
  geometry::appendMesh(all, more);
  return all;
}

TriangleMesh withoutPaint(const TriangleMesh& painted, const TriangleMesh& less, double finest) {
  if (less.empty())
    return painted;
  TriangleMesh left;
  const Cover cover(less);
  for (std::size_t t = 0; t < painted.triangles.size(); ++t)
    addUncovered(left, pieceOf(painted, t), cover, finest);
  return left;
}

double finestOf(const Brush& brush) {
  return kFinest * brush.radius;
}

TriangleMesh withoutPaint(const TriangleMesh& painted, const Brush& brush) {
  TriangleMesh left;
  for (std::size_t t = 0; t < painted.triangles.size(); ++t)
    addPieces(left, pieceOf(painted, t), brush, false);
  return left;
}

} // namespace voluta::regions
