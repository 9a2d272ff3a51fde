#include "planar/pith_body.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/boundary.h"
#include "geometry/measures.h"
#include "geometry/mesh_boolean.h"
#include "geometry/remesh.h"
#include "planar/pith_limbs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::planar {

namespace {
using Eigen::Vector3d;

constexpr int kSides = 32;        // around a limb
constexpr int kCapRings = 6;      // of the half ball at its end
constexpr double kSpacing = 0.01; // of points, as a share of the part's diagonal

// A limb's axis with a radius per point.
struct Rod {
  std::vector<Vector3d> points;
  std::vector<double> radiusMm;
};

// Returns how much of the gain is left at a distance from a branching.
double fade(double mm, double overMm) {
  if (mm >= overMm)
    return 0.0;
  const double c = std::cos(0.5 * base::kPi * mm / overMm);
  return c * c;
}

Rod rodOf(const Limb& limb, const PithRule& rule) {
  Rod rod{limb.points, {}};
  const double length = limb.lengthMm();
  double along = 0.0;
  for (std::size_t i = 0; i < limb.points.size(); ++i) {
    if (i > 0)
      along += (limb.points[i] - limb.points[i - 1]).norm();
    double gain = 1.0;
    if (limb.branchesFirst)
      gain += rule.branchGain * fade(along, 2.0 * limb.partRadiusMm.front());
    if (limb.branchesLast)
      gain += rule.branchGain * fade(length - along, 2.0 * limb.partRadiusMm.back());
    rod.radiusMm.push_back(gain * std::max(rule.minRadiusMm, rule.share * limb.partRadiusMm[i]));
  }
  return rod;
}

// Lengthens the rod beyond the surface, so that cutting it there removes its rounded end.
void extendEnd(Rod& rod) {
  const Vector3d along = (rod.points.back() - rod.points.end()[-2]).normalized();
  rod.points.push_back(rod.points.back() + rod.radiusMm.back() * along);
  rod.radiusMm.push_back(rod.radiusMm.back());
}

// The rings of a rod's surface, with half balls at its ends.
geometry::TriangleMesh solidOf(const Rod& rod) {
  geometry::TriangleMesh mesh;
  const std::size_t n = rod.points.size();
  const auto tangent = [&](std::size_t i) -> Vector3d {
    return (rod.points[std::min(i + 1, n - 1)] - rod.points[i > 0 ? i - 1 : 0]).normalized();
  };
  Vector3d t = tangent(0), u = t.unitOrthogonal();
  const auto addRing = [&](const Vector3d& centre, double radius) {
    const Vector3d v = t.cross(u);
    for (int k = 0; k < kSides; ++k) {
      const double angle = base::kTwoPi * k / kSides;
      mesh.vertices.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
  };
  const auto addCap = [&](std::size_t i, int from, int to, int step) {
    for (int ring = from; ring != to; ring += step) {
      const double lift = 0.5 * base::kPi * std::abs(ring) / kCapRings;
      addRing(rod.points[i] + (ring < 0 ? -1.0 : 1.0) * rod.radiusMm[i] * std::sin(lift) * t,
              rod.radiusMm[i] * std::cos(lift));
    }
  };
  addCap(0, 1 - kCapRings, 0, 1);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d next = tangent(i);
    u = (Eigen::Quaterniond::FromTwoVectors(t, next) * u).normalized();
    t = next;
    addRing(rod.points[i], rod.radiusMm[i]);
  }
  addCap(n - 1, 1, kCapRings, 1);
  const int rings = static_cast<int>(mesh.vertices.size()) / kSides;
  for (int ring = 0; ring + 1 < rings; ++ring)
    for (int k = 0; k < kSides; ++k) {
      const int a = ring * kSides + k, b = ring * kSides + (k + 1) % kSides;
      mesh.triangles.push_back({a, b, b + kSides});
      mesh.triangles.push_back({a, b + kSides, a + kSides});
    }
  const int low = static_cast<int>(mesh.vertices.size()), high = low + 1,
            last = (rings - 1) * kSides;
  mesh.vertices.push_back(rod.points.front() - rod.radiusMm.front() * tangent(0));
  mesh.vertices.push_back(rod.points.back() + rod.radiusMm.back() * t);
  for (int k = 0; k < kSides; ++k) {
    const int next = (k + 1) % kSides;
    mesh.triangles.push_back({low, next, k});
    mesh.triangles.push_back({high, last + k, last + next});
  }
  return mesh;
}

// The flow moves vertices: the long triangles of CAD have none between the ends of a limb.
geometry::TriangleMesh forFlow(const geometry::TriangleMesh& part) {
  constexpr std::size_t kTriangles = 8000;
  constexpr double kLong = 4.0; // even edges
  return geometry::longestEdge(part) > kLong * geometry::evenEdge(part, kTriangles)
             ? geometry::remeshed(part, kTriangles)
             : part;
}

[[noreturn]] void refuse(const base::Message& what, const base::Message& remedy) {
  throw base::Error(base::ErrorCode::UnusableInput, what, "pith"_text, remedy);
}

} // namespace

PithBody pithBody(const geometry::TriangleMesh& part, const PithRule& rule,
                  const base::RunContext& ctx) {
  base::require(rule.share > 0.0 && rule.share < 1.0 && rule.minRadiusMm > 0.0 &&
                    rule.branchGain >= 0.0,
                "pithBody: a share between 0 and 1, a radius above 0");
  if (part.empty() || !geometry::boundaryLoops(part).empty())
    refuse("the part is not closed"_text, "repair the part first"_text);
  ctx.report(0.0, "find the skeleton"_text);
  const CurveSkeleton skeleton = curveSkeleton(forFlow(part), ctx.sub(0.0, 0.7));
  const std::vector<Limb> limbs = limbsOf(skeleton, geometry::MeshQuery(part),
                                          kSpacing * geometry::bounds(part).diagonal().norm());
  if (limbs.empty())
    refuse("the part has no limbs"_text,
           "use infill that is dense along the part's middle (`sparsePattern=pith`)"_text);
  PithBody body;
  body.minRadiusMm = std::numeric_limits<double>::infinity();
  std::optional<geometry::TriangleMesh> joined;
  for (const Limb& limb : limbs) {
    ctx.checkpoint();
    Rod rod = rodOf(limb, rule);
    ++body.limbs;
    body.lengthMm += limb.lengthMm();
    body.minRadiusMm = std::min(body.minRadiusMm, *std::ranges::min_element(rod.radiusMm));
    body.maxRadiusMm = std::max(body.maxRadiusMm, *std::ranges::max_element(rod.radiusMm));
    if (!limb.branchesLast)
      extendEnd(rod);
    if (!limb.branchesFirst) {
      std::ranges::reverse(rod.points);
      std::ranges::reverse(rod.radiusMm);
      extendEnd(rod);
    }
    const geometry::TriangleMesh solid = solidOf(rod);
    joined = joined
                 ? geometry::meshBoolean(geometry::BooleanOperation::Union, *joined, solid, false)
                 : solid;
    if (!joined)
      refuse("the limbs of the pith cannot be joined"_text, "change the pith's share"_text);
  }
  auto cut = geometry::meshBoolean(geometry::BooleanOperation::Intersection, *joined, part, false);
  if (!cut || cut->empty())
    refuse("the pith cannot be cut at the part's surface"_text, "repair the part first"_text);
  body.mesh = std::move(*cut);
  return body;
}

} // namespace voluta::planar
