#include "substrate/skin.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "substrate/ground_distance.h"
#include "substrate/levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace voluta::substrate {

namespace {
using Eigen::Vector3d;
using geometry::TriangleMesh;

constexpr double kSmooth =
    0.82; // cosine of 35 degrees: faces that meet at less continue each other
constexpr double kOnSurfaceMm = 1e-9, kOnSideMm = 1e-6;
constexpr double kMostAhead = 3.0; // [depths]: longest continuation of the surface
constexpr double kEdgeRoom = 0.3;  // [grid]: beyond an edge that still belongs to the skin

// The triangles at each edge of a mesh.
class Edges {
public:
  explicit Edges(const TriangleMesh& mesh) : mesh_(mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        at_[key(t, k)].push_back(t);
  }
  // Returns the other triangle at a side, if there is exactly one.
  std::optional<std::size_t> beyond(std::size_t t, std::size_t k) const {
    const std::vector<std::size_t>& both = at_.at(key(t, k));
    if (both.size() != 2)
      return std::nullopt;
    return both[0] == t ? both[1] : both[0];
  }

private:
  std::pair<int, int> key(std::size_t t, std::size_t k) const {
    return std::minmax({mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3]});
  }
  const TriangleMesh& mesh_;
  std::map<std::pair<int, int>, std::vector<std::size_t>> at_;
};

TriangleMesh facesOf(const TriangleMesh& part, const std::vector<char>& isKept) {
  return geometry::subMesh(part, std::vector<bool>(isKept.begin(), isKept.end()));
}

// Adds the faces that continue the kept ones without an edge.
void addSmoothNeighbours(const TriangleMesh& part, std::vector<char>& isKept) {
  const Edges edges(part);
  std::vector<std::size_t> open;
  for (std::size_t t = 0; t < isKept.size(); ++t)
    if (isKept[t])
      open.push_back(t);
  while (!open.empty()) {
    const std::size_t t = open.back();
    open.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto other = edges.beyond(t, k);
      if (other && !isKept[*other] &&
          geometry::triangleNormal(part, t).dot(geometry::triangleNormal(part, *other)) >=
              kSmooth) {
        isKept[*other] = 1;
        open.push_back(*other);
      }
    }
  }
}

// Where the kept faces end.
struct Rim {
  std::size_t triangle, side;
  Vector3d outward; // unit, in the plane of the triangle
  // [depths]: how far the part reaches beyond the rim at that depth below it; negative: the surface
  // goes on there, or the part rises
  double ahead;
};

// Calls `use` with each rim.
template <typename Use>
void forEachRim(const TriangleMesh& part, const std::vector<char>& isKept, const Use& use) {
  const Edges edges(part);
  for (std::size_t t = 0; t < isKept.size(); ++t) {
    if (!isKept[t])
      continue;
    const Vector3d normal = geometry::triangleNormal(part, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto other = edges.beyond(t, k);
      if (other && isKept[*other])
        continue;
      const Vector3d &a = part.corner(t, static_cast<int>(k)),
                     &b = part.corner(t, static_cast<int>((k + 1) % 3));
      Rim rim{t, k, (b - a).cross(normal).normalized(), -1.0};
      if (other) {
        const Vector3d side = geometry::triangleNormal(part, *other);
        // Along the neighbour, away from the rim.
        const Vector3d along = side.cross(b - a).normalized() * -1.0;
        const double down = -along.dot(normal);
        if (side.dot(normal) < kSmooth && down > 0.0)
          rim.ahead = std::min(kMostAhead, std::max(0.0, along.dot(rim.outward)) / down);
      }
      use(rim);
    }
  }
}

void addQuad(TriangleMesh& mesh, const Vector3d& a, const Vector3d& b, const Vector3d& ahead) {
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, b + ahead, a + ahead});
  mesh.triangles.push_back({first + 1, first, first + 3});
  mesh.triangles.push_back({first + 1, first + 3, first + 2});
}

// Appends the continuation of the kept faces beyond ridges.
void continueAhead(const TriangleMesh& part, const std::vector<char>& isKept, double depthMm,
                   double roomMm, TriangleMesh& surface) {
  forEachRim(part, isKept, [&](const Rim& rim) {
    if (rim.ahead >= 0.0)
      addQuad(surface, part.corner(rim.triangle, static_cast<int>(rim.side)),
              part.corner(rim.triangle, static_cast<int>((rim.side + 1) % 3)),
              (rim.ahead * depthMm + roomMm) * rim.outward);
  });
}

// Returns the numbers of the kept faces among them.
std::vector<std::size_t> numbersOf(const std::vector<char>& isKept) {
  std::vector<std::size_t> number(isKept.size(), 0);
  for (std::size_t t = 0, next = 0; t < number.size(); ++t)
    if (isKept[t])
      number[t] = next++;
  return number;
}

Eigen::AlignedBox3d boxAround(const TriangleMesh& mesh, double marginMm) {
  Eigen::AlignedBox3d box = geometry::bounds(mesh);
  box.min().array() -= marginMm;
  box.max().array() += marginMm;
  return box;
}

std::shared_ptr<const geometry::MeshQuery> queryOf(const TriangleMesh& surface) {
  return std::make_shared<const geometry::MeshQuery>(surface, geometry::MeshQuery::Of::Surface);
}

// Returns whether a point of a triangle is on a side.
bool isOnSide(const TriangleMesh& mesh, std::size_t t, std::size_t k, const Vector3d& p) {
  const Vector3d &a = mesh.corner(t, static_cast<int>(k)),
                 &b = mesh.corner(t, static_cast<int>((k + 1) % 3));
  return (p - a).cross(b - a).norm() < kOnSideMm * std::max((b - a).norm(), kOnSurfaceMm);
}

// The surface that levels follow: faces of a part, and their continuation.
class Followed {
public:
  Followed(const TriangleMesh& part, const std::vector<char>& isFollowed, double depthMm,
           double roomMm)
      : surface_(facesOf(part, isFollowed)) {
    isRim_.resize(surface_.triangles.size(), {0, 0, 0});
    const std::vector<std::size_t> number = numbersOf(isFollowed);
    forEachRim(part, isFollowed, [&](const Rim& rim) {
      isRim_[number[rim.triangle]][rim.side] = rim.ahead < 0.0 ? 1 : 0;
    });
    continueAhead(part, isFollowed, depthMm, roomMm, surface_);
    while (isRim_.size() < surface_.triangles.size()) {
      isRim_.push_back({0, 1, 0}); // as addQuad(): its first side is on the part
      isRim_.push_back({0, 1, 1});
    }
    query_ = queryOf(surface_);
  }

  struct Foot {
    Vector3d toPoint; // from the surface
    double mm;
    Vector3d normal;
    bool isAbove; // away from the part; false beyond rims
  };
  Foot footOf(const Vector3d& p) const {
    const geometry::MeshQuery::Closest on = query_->closest(p);
    const auto t = static_cast<std::size_t>(on.triangle);
    Foot foot{p - on.point, on.distance, geometry::triangleNormal(surface_, t), false};
    if (foot.toPoint.dot(foot.normal) <= 0.0)
      return foot;
    foot.isAbove = true;
    for (std::size_t k = 0; k < 3; ++k)
      if (isRim_[t][k] != 0 && isOnSide(surface_, t, k, on.point))
        foot.isAbove = false;
    return foot;
  }

private:
  TriangleMesh surface_;
  std::vector<std::array<char, 3>> isRim_; // per triangle and side
  std::shared_ptr<const geometry::MeshQuery> query_;
};

// The surface at depthMm below a followed one.
GroundDistance coreBelow(const std::shared_ptr<const Followed>& surface, double depthMm) {
  return {[surface, depthMm](const Vector3d& p) -> Vector3d {
            const Followed::Foot foot = surface->footOf(p);
            if (foot.mm < kOnSurfaceMm)
              return p - depthMm * foot.normal;
            const double over = foot.isAbove ? depthMm + foot.mm : foot.mm - depthMm;
            return p - over / foot.mm * foot.toPoint;
          },
          [surface, depthMm](const Vector3d& p) {
            const Followed::Foot foot = surface->footOf(p);
            return !foot.isAbove && foot.mm > depthMm;
          }};
}
} // namespace

std::vector<char> upperFaces(const TriangleMesh& part, double maxSlopeRad) {
  std::vector<char> isUpper(part.triangles.size());
  for (std::size_t t = 0; t < isUpper.size(); ++t)
    isUpper[t] = geometry::triangleNormal(part, t).z() >= std::cos(maxSlopeRad) ? 1 : 0;
  return isUpper;
}

std::vector<char> paintedFaces(const TriangleMesh& part, const TriangleMesh& painted) {
  const geometry::MeshQuery query(part, geometry::MeshQuery::Of::Surface);
  std::vector<double> paintedMm2(part.triangles.size(), 0.0);
  for (std::size_t t = 0; t < painted.triangles.size(); ++t) {
    const Vector3d middle =
        (painted.corner(t, 0) + painted.corner(t, 1) + painted.corner(t, 2)) / 3.0;
    paintedMm2[static_cast<std::size_t>(query.closest(middle).triangle)] +=
        geometry::triangleArea(painted, t);
  }
  std::vector<char> isPainted(part.triangles.size());
  for (std::size_t t = 0; t < isPainted.size(); ++t)
    isPainted[t] = paintedMm2[t] > 0.0 && paintedMm2[t] >= 0.5 * geometry::triangleArea(part, t);
  return isPainted;
}

SkinSurface::SkinSurface(const TriangleMesh& part, const Skin& skin, double gridMm)
    : depthMm_(skin.depthMm), gridMm_(gridMm) {
  base::require(skin.depthMm > 0.0 && gridMm > 0.0, "a skin with a depth");
  const std::vector<char>& isFollowed = skin.faces;
  surface_ = facesOf(part, isFollowed);
  if (surface_.empty())
    return;
  outward_.resize(surface_.triangles.size(),
                  {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()});
  const std::vector<std::size_t> number = numbersOf(isFollowed);
  forEachRim(part, isFollowed, [&](const Rim& rim) {
    if (rim.ahead < 0.0)
      outward_[number[rim.triangle]][rim.side] = rim.outward;
  });
  continueAhead(part, isFollowed, depthMm_, 2.0 * gridMm, surface_);
  outward_.resize(surface_.triangles.size(),
                  {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()});
  query_ = queryOf(surface_);
}

double SkinSurface::excessOfDepth(const Vector3d& p) const {
  return query_->closest(p).distance - depthMm_;
}

double SkinSurface::excess(const Vector3d& p) const {
  const geometry::MeshQuery::Closest on = query_->closest(p);
  const auto t = static_cast<std::size_t>(on.triangle);
  double excess = on.distance - depthMm_;
  for (std::size_t k = 0; k < 3; ++k)
    if (const Vector3d& outward = outward_[t][k];
        outward != Vector3d::Zero() && isOnSide(surface_, t, k, on.point))
      excess = std::max(excess, outward.dot(p - on.point) - kEdgeRoom * gridMm_);
  return excess;
}

LevelFamily skinLevels(const TriangleMesh& solid, const TriangleMesh& part, const Skin& skin,
                       const LevelOptions& options) {
  std::vector<char> followed = skin.faces;
  addSmoothNeighbours(part, followed);
  const auto surface =
      std::make_shared<const Followed>(part, followed, skin.depthMm, 2.0 * offsetGridMm(options));
  const GroundDistance core = coreBelow(surface, skin.depthMm);
  LevelFamily family;
  family.ground = {[core](const Vector3d& p) { return core.signedMm(p); }};
  family.outward = [core](const Vector3d& p) { return core.outward(p); };
  family.endsBelowSurface = false;
  LevelOptions equal = options;
  equal.firstLayerMm = 0.0;
  const std::vector<double> bounds = levelBounds(0.0, skin.depthMm, equal);
  family.count = static_cast<int>(bounds.size()) - 1;
  family.level =
      [bounds, levels = OffsetLevels(core, boxAround(solid, 2.0 * levelEdgeMm(options)),
                                     offsetGridMm(options))](int k, const base::RunContext& ctx) {
        const double inner = bounds[static_cast<std::size_t>(k)],
                     outer = bounds[static_cast<std::size_t>(k) + 1];
        return levels.at(0.5 * (inner + outer), outer - inner, ctx);
      };
  return family;
}

TriangleMesh bodyAround(const TriangleMesh& surface, double depthMm, double gridMm,
                        const base::RunContext& ctx) {
  base::require(!surface.empty() && depthMm > 0.0 && gridMm > 0.0, "a surface and lengths");
  const auto query = queryOf(surface);
  const GroundDistance ground{[query](const Vector3d& p) { return query->closest(p).point; },
                              [](const Vector3d&) { return false; }};
  return offsetLevel(ground, depthMm, 1.0, boxAround(surface, depthMm + 2.0 * gridMm), gridMm, ctx)
      .surface;
}

} // namespace voluta::substrate
