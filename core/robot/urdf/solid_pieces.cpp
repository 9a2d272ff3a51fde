#include "robot/urdf/solid_pieces.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "geometry/principal_axes.h"
#include "robot/shape/capsule_fit.h"
#include "robot/shape/shape_moves.h"
#include "robot/shape/triangle_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace voluta::robot {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;
using geometry::TriangleMesh;
using Points = std::vector<Vector3d>;

constexpr int kAlong = 8;       // Cubes along the longest side
constexpr double kAdded = 0.02; // Maximum volume added by joining, as a share of the whole box
constexpr double kFits = 1.1; // Maximum ratio of a solid's volume to that of the enclosed component
constexpr double kHalfThickMm = 0.5; // Half of the minimum thickness of flat pieces
constexpr double kSlackMm = 1e-6;    // Against rounding

AlignedBox3d boxOf(const Points& points) {
  AlignedBox3d box;
  for (const Vector3d& p : points)
    box.extend(p);
  return box;
}

double volumeOf(const Box& box) {
  return 8.0 * box.half.prod();
}
double volumeOf(const Frustum& cylinder) {
  return base::kPi * cylinder.r0 * cylinder.r0 * (cylinder.p1 - cylinder.p0).norm();
}
double volumeOf(const Capsule& capsule) {
  const double r = capsule.radius;
  return base::kPi * r * r * ((capsule.p1 - capsule.p0).norm() + 4.0 / 3.0 * r);
}

struct Solid {
  Shape shape;
  double volume = std::numeric_limits<double>::infinity();
};

template <typename S> void takeIfLess(const S& shape, Solid& best) {
  if (const double volume = volumeOf(shape); volume < best.volume)
    best = {shape, volume};
}

Frustum cylinderAbout(const Points& points, const Vector3d& foot, const Vector3d& axis) {
  double low = std::numeric_limits<double>::infinity(), high = -low, radius = 0.0;
  for (const Vector3d& p : points) {
    const double along = (p - foot).dot(axis);
    low = std::min(low, along);
    high = std::max(high, along);
    radius = std::max(radius, (p - foot - along * axis).norm());
  }
  const double thick = std::max(0.0, kHalfThickMm - 0.5 * (high - low)) + kSlackMm;
  radius = std::max(radius, kHalfThickMm) + kSlackMm;
  return {foot + (low - thick) * axis, foot + (high + thick) * axis, radius, radius};
}

// Returns the smallest of an axis-aligned box, and cylinders and capsules along the coordinate axes
// and the points' principal axes.
Solid smallestAbout(const Points& points) {
  const AlignedBox3d bounds = boxOf(points);
  Solid best;
  Eigen::Isometry3d centre = Eigen::Isometry3d::Identity();
  centre.translation() = bounds.center();
  takeIfLess(Box{centre, (0.5 * bounds.sizes()).cwiseMax(kHalfThickMm).array() + kSlackMm}, best);
  for (int axis = 0; axis < 3; ++axis) {
    const Capsule capsule = enclosingCapsule(points, Vector3d::Unit(axis));
    takeIfLess(capsule, best);
    if (const Vector3d along = capsule.p1 - capsule.p0; along.norm() > 0.0)
      takeIfLess(cylinderAbout(points, capsule.p0, along.normalized()), best);
    takeIfLess(cylinderAbout(points, bounds.center(), Vector3d::Unit(axis)), best);
  }
  return best;
}

struct Piece {
  Points points; // Empty: joined to another piece
  AlignedBox3d box;
  std::set<std::size_t> neighbours;
};

double volumeOf(const AlignedBox3d& box) {
  return box.sizes().prod();
}

// Cubes over the mesh's bounds, extending beyond them on all sides: flat sides parallel to the axes
// are then inside cubes and not between them.
class Cubes {
public:
  explicit Cubes(const AlignedBox3d& bounds) : edge_(bounds.sizes().maxCoeff() / (kAlong - 0.5)) {
    for (int k = 0; k < 3; ++k) {
      count_[static_cast<std::size_t>(k)] =
          std::max(1, static_cast<int>(std::ceil(bounds.sizes()[k] / edge_ + 0.25)));
      low_[k] = bounds.center()[k] - 0.5 * edge_ * count(k);
    }
  }
  int count(int axis) const { return count_[static_cast<std::size_t>(axis)]; }
  double plane(int axis, int n) const { return low_[axis] + n * edge_; }
  Vector3d corner(int x, int y, int z) const { return {plane(0, x), plane(1, y), plane(2, z)}; }

private:
  double edge_;
  std::array<int, 3> count_{};
  Vector3d low_ = Vector3d::Zero();
};

// Divides the triangles into the slabs between consecutive planes of the cubes.
std::vector<std::vector<Corners>> slabs(std::vector<Corners> triangles, const Cubes& cubes,
                                        int axis) {
  std::vector<std::vector<Corners>> out;
  for (int n = 1; n < cubes.count(axis); ++n) {
    auto sides = cut(triangles, {Vector3d::Unit(axis), cubes.plane(axis, n)});
    out.push_back(std::move(sides[0]));
    triangles = std::move(sides[1]);
  }
  out.push_back(std::move(triangles));
  return out;
}

// Returns the piece of the solid in each cube: corners of the triangles clipped to it, and corners
// of the cube that are inside. Their hull contains all of the solid in the cube.
std::vector<Piece> cubePieces(const TriangleMesh& mesh, const base::RunContext& ctx) {
  const Cubes cubes(geometry::bounds(mesh));
  const geometry::MeshQuery query(mesh);
  const int nx = cubes.count(0), ny = cubes.count(1), nz = cubes.count(2);
  std::map<std::array<int, 3>, bool> inside;
  for (int x = 0; x <= nx; ++x)
    for (int y = 0; y <= ny; ++y)
      for (int z = 0; z <= nz; ++z)
        inside[{x, y, z}] = query.inside(cubes.corner(x, y, z));
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    triangles.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});

  std::vector<Piece> pieces;
  std::map<std::array<int, 3>, std::size_t> at;
  const auto alongX = slabs(std::move(triangles), cubes, 0);
  for (int x = 0; x < nx; ++x) {
    const auto alongY = slabs(alongX[static_cast<std::size_t>(x)], cubes, 1);
    for (int y = 0; y < ny; ++y) {
      ctx.checkpoint();
      const auto alongZ = slabs(alongY[static_cast<std::size_t>(y)], cubes, 2);
      for (int z = 0; z < nz; ++z) {
        Piece piece;
        for (const Corners& triangle : alongZ[static_cast<std::size_t>(z)])
          piece.points.insert(piece.points.end(), triangle.begin(), triangle.end());
        for (int corner = 0; corner < 8; ++corner) {
          const std::array<int, 3> c{x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2)};
          if (inside.at(c))
            piece.points.push_back(cubes.corner(c[0], c[1], c[2]));
        }
        if (piece.points.empty())
          continue;
        piece.box = boxOf(piece.points);
        const std::size_t index = pieces.size();
        at[{x, y, z}] = index;
        for (const std::array<int, 3>& before :
             {std::array{x - 1, y, z}, std::array{x, y - 1, z}, std::array{x, y, z - 1}})
          if (const auto other = at.find(before); other != at.end()) {
            piece.neighbours.insert(other->second);
            pieces[other->second].neighbours.insert(index);
          }
        pieces.push_back(std::move(piece));
      }
    }
  }
  return pieces;
}

// Joins neighbouring pieces, the cheapest pair first.
class Joining {
public:
  explicit Joining(std::vector<Piece> pieces) : pieces_(std::move(pieces)), left_(pieces_.size()) {
    for (std::size_t a = 0; a < pieces_.size(); ++a)
      for (const std::size_t b : pieces_[a].neighbours)
        if (a < b)
          consider(a, b);
  }

  std::size_t left() const { return left_; }
  bool hasPair() const { return !costs_.empty(); }
  // Returns the volume that the cheapest join adds to the sum of all boxes. Precondition: there is
  // a pair.
  double lowestCost() const { return cheapest()->second; }
  void joinCheapest() {
    const auto [a, b] = cheapest()->first;
    for (const std::size_t gone : {a, b})
      for (const std::size_t other : pieces_[gone].neighbours)
        costs_.erase(std::minmax(gone, other));
    for (const std::size_t other : pieces_[b].neighbours) {
      pieces_[other].neighbours.erase(b);
      if (other != a) {
        pieces_[a].neighbours.insert(other);
        pieces_[other].neighbours.insert(a);
      }
    }
    Piece gone = std::exchange(pieces_[b], Piece());
    pieces_[a].points.insert(pieces_[a].points.end(), gone.points.begin(), gone.points.end());
    pieces_[a].box.extend(gone.box);
    --left_;
    for (const std::size_t other : pieces_[a].neighbours)
      consider(a, other);
  }
  // For meshes with more disconnected pieces than allowed.
  void letAllBeNeighbours() {
    for (std::size_t a = 0; a < pieces_.size(); ++a)
      for (std::size_t b = a + 1; b < pieces_.size(); ++b)
        if (!pieces_[a].points.empty() && !pieces_[b].points.empty()) {
          pieces_[a].neighbours.insert(b);
          pieces_[b].neighbours.insert(a);
          consider(a, b);
        }
  }
  std::vector<Points> points() && {
    std::vector<Points> out;
    for (Piece& piece : pieces_)
      if (!piece.points.empty())
        out.push_back(std::move(piece.points));
    return out;
  }

private:
  using Costs = std::map<std::pair<std::size_t, std::size_t>, double>;

  void consider(std::size_t a, std::size_t b) {
    costs_[std::minmax(a, b)] = volumeOf(pieces_[a].box.merged(pieces_[b].box)) -
                                volumeOf(pieces_[a].box) - volumeOf(pieces_[b].box);
  }
  Costs::const_iterator cheapest() const {
    return std::min_element(costs_.begin(), costs_.end(), [](const auto& one, const auto& other) {
      return one.second < other.second;
    });
  }

  std::vector<Piece> pieces_;
  std::size_t left_;
  Costs costs_;
};

// Returns the points of the joined pieces: each component of `whole` starts as one piece, the rest
// of the mesh as many.
std::vector<Points> joinedPieces(const TriangleMesh& mesh, const std::vector<Points>& whole,
                                 int maxPieces, const base::RunContext& ctx) {
  std::vector<Piece> pieces;
  AlignedBox3d bounds;
  if (!mesh.empty()) {
    pieces = cubePieces(mesh, ctx);
    bounds = geometry::bounds(mesh);
  }
  for (const Points& points : whole) {
    pieces.push_back({points, boxOf(points), {}});
    bounds.extend(pieces.back().box);
  }
  Joining joining(std::move(pieces));
  for (double added = 0.0; joining.left() > 1;) {
    ctx.checkpoint();
    const bool tooMany = joining.left() > static_cast<std::size_t>(maxPieces);
    if (!joining.hasPair() && tooMany)
      joining.letAllBeNeighbours();
    if (!joining.hasPair() ||
        (!tooMany && added + joining.lowestCost() > kAdded * volumeOf(bounds)))
      break;
    added += std::max(0.0, joining.lowestCost());
    joining.joinCheapest();
  }
  return std::move(joining).points();
}

std::vector<Solid> solidsAlong(TriangleMesh mesh, const Eigen::Matrix3d& axes, int maxPieces,
                               const base::RunContext& ctx) {
  for (Vector3d& p : mesh.vertices)
    p = axes.transpose() * p;
  std::vector<Points> whole;
  const geometry::Components components = geometry::components(mesh);
  std::vector<bool> left(mesh.triangles.size(), true);
  for (int c = 0; components.count <= maxPieces && c < components.count; ++c) {
    std::vector<bool> in;
    for (const int of : components.ofTriangle)
      in.push_back(of == c);
    const TriangleMesh component = geometry::subMesh(mesh, in);
    if (smallestAbout(component.vertices).volume <= kFits * std::abs(geometry::volume(component))) {
      whole.push_back(component.vertices);
      for (std::size_t t = 0; t < in.size(); ++t)
        left[t] = left[t] && !in[t];
    }
  }
  Eigen::Isometry3d back = Eigen::Isometry3d::Identity();
  back.linear() = axes;
  std::vector<Solid> solids;
  for (const Points& points : joinedPieces(geometry::subMesh(mesh, left), whole, maxPieces, ctx)) {
    solids.push_back(smallestAbout(points));
    solids.back().shape = moved(std::move(solids.back().shape), back);
  }
  return solids;
}

// Right-handed.
Eigen::Matrix3d ownAxes(const Points& points) {
  Eigen::Matrix3d axes = geometry::principalAxes(points);
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

} // namespace

std::vector<Shape> solidPieces(const TriangleMesh& mesh, int maxPieces,
                               const base::RunContext& ctx) {
  base::require(!mesh.empty() && maxPieces >= 1, "triangles to enclose");
  base::require(geometry::bounds(mesh).sizes().maxCoeff() > 0.0, "a mesh with an extent");
  std::vector<Solid> best;
  double lowestCost = std::numeric_limits<double>::infinity();
  for (const Eigen::Matrix3d& axes :
       {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), ownAxes(mesh.vertices)}) {
    std::vector<Solid> solids = solidsAlong(mesh, axes, maxPieces, ctx);
    double sum = 0.0;
    for (const Solid& solid : solids)
      sum += solid.volume;
    // Prefer the file's axes unless the others save volume.
    if (sum < lowestCost * (1.0 - 1e-6)) {
      lowestCost = sum;
      best = std::move(solids);
    }
  }
  std::vector<Shape> shapes;
  for (Solid& solid : best)
    shapes.push_back(std::move(solid.shape));
  return shapes;
}

} // namespace voluta::robot
