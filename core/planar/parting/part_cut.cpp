#include "planar/parting/part_cut.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/append_mesh.h"
#include "geometry/measures.h"
#include "geometry/mesh_boolean.h"
#include "planar/nudged.h"
#include "planar/parting/joint_axes.h"
#include "planar/parting/pin_places.h"
#include "planar/plane_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace voluta::planar {

namespace {

using base::Error;
using base::ErrorCode;
using Eigen::Vector2d;
using Eigen::Vector3d;
using geometry::BooleanOperation;
using geometry::TriangleMesh;

constexpr int kSides = 48;                   // of a pin
constexpr double kWallShare = 0.3;           // of a pin's diameter
constexpr double kMinWallMm = 1.2;           // around holes
constexpr double kChamferShare = 0.1;        // of a pin's diameter, at its ends
constexpr double kFlankRad = base::kPi / 12; // of a dovetail
constexpr double kLostShare = 1e-6;          // of the volume, by rounding
constexpr double kMinSlabMm = 0.05;          // as thick as the thinnest layers

double wallMm(const Joint& joint) {
  return std::max(kMinWallMm, kWallShare * joint.sizeMm);
}

struct PinEnd {
  double heightMm = 0.0, radiusMm = 0.0;
};

// Returns a solid of revolution about the normal; its ends are flat.
TriangleMesh turned(const Vector3d& at, const Vector3d& normal,
                    const std::vector<PinEnd>& profile) {
  const PlaneFrame axes = jointAxes(normal);
  TriangleMesh mesh;
  for (const PinEnd& end : profile)
    for (int k = 0; k < kSides; ++k) {
      const double angle = base::kTwoPi * k / kSides;
      mesh.vertices.push_back(at + end.heightMm * normal +
                              end.radiusMm *
                                  (std::cos(angle) * axes.across + std::sin(angle) * axes.along));
    }
  const int rings = static_cast<int>(profile.size());
  for (int ring = 0; ring + 1 < rings; ++ring)
    for (int k = 0; k < kSides; ++k) {
      const int a = ring * kSides + k, b = ring * kSides + (k + 1) % kSides;
      mesh.triangles.push_back({a, b, b + kSides});
      mesh.triangles.push_back({a, b + kSides, a + kSides});
    }
  const int top = (rings - 1) * kSides;
  for (int k = 1; k + 1 < kSides; ++k) {
    mesh.triangles.push_back({0, k + 1, k});
    mesh.triangles.push_back({top, top + k, top + k + 1});
  }
  return mesh;
}

[[noreturn]] void failsToJoin() {
  throw Error(ErrorCode::UnusableInput, "the joint cannot be cut out of this mesh"_text, {},
              "repair the part, or move the plane"_text);
}

TriangleMesh combinedOrFail(BooleanOperation how, const TriangleMesh& a, const TriangleMesh& b) {
  auto made = geometry::meshBoolean(how, a, b, true);
  if (!made || made->empty())
    failsToJoin();
  return std::move(*made);
}

// Throws if the volumes differ by more than rounding.
void requireVolume(const TriangleMesh& mesh, double mm3, double wholeMm3) {
  if (!isClosed(mesh) || std::abs(geometry::volume(mesh) - mm3) > kLostShare * wholeMm3)
    failsToJoin();
}

Vector3d centroidOf(const TriangleMesh& section) {
  Vector3d sum = Vector3d::Zero();
  double area = 0.0;
  for (std::size_t t = 0; t < section.triangles.size(); ++t) {
    const double own = geometry::triangleArea(section, t);
    sum += own * (section.corner(t, 0) + section.corner(t, 1) + section.corner(t, 2)) / 3.0;
    area += own;
  }
  return area > 0.0 ? (sum / area).eval() : section.vertices.front();
}

// Throws if the bodies of a half that the plane cut are all too thin. `outward`: away from the
// plane; `offsetMm`: minus its distance from the origin along that direction.
void requireThickness(const TriangleMesh& half, double offsetMm, const Vector3d& outward,
                      const TriangleMesh& section) {
  const double onPlaneMm = 1e-6 * kMinSlabMm + 1e-9 * geometry::bounds(half).diagonal().norm();
  double thickestMm = 0.0;
  for (const TriangleMesh& body : bodiesOf(half)) {
    double nearest = 1e300, farthest = 0.0;
    for (const Vector3d& v : body.vertices) {
      const double height = outward.dot(v) + offsetMm;
      nearest = std::min(nearest, std::abs(height));
      farthest = std::max(farthest, height);
    }
    if (nearest <= onPlaneMm)
      thickestMm = std::max(thickestMm, farthest);
  }
  if (thickestMm >= kMinSlabMm)
    return;
  const Vector3d at = centroidOf(section);
  throw Error(ErrorCode::UnusableInput,
              base::message("the plane leaves a slab of {thickness} at {place}, thinner than a "
                            "layer"_text,
                            base::mm(thickestMm), base::Point{at.x(), at.y(), at.z()}),
              {}, "move the plane further into the part"_text);
}

struct Halves {
  PartHalves halves;
  TriangleMesh section;
  Plane plane; // as used
};

Halves cutPlain(const TriangleMesh& part, const Plane& plane) {
  const PlaneCut cut = cutByPlane(tagged(part), plane, 0);
  Halves out;
  out.plane = {plane.normal, cut.offsetMm};
  out.halves.below = cut.below.mesh;
  for (const TaggedMesh& solid : cut.above)
    geometry::appendMesh(out.halves.above, solid.mesh);
  if (out.halves.below.empty() || out.halves.above.empty())
    throw Error(ErrorCode::UnusableInput, "the plane does not cut the part"_text, {},
                "move the plane into the part"_text);
  out.halves.sectionMm2 = cut.sectionMm2;
  if (!(cut.sectionMm2 > 0.0))
    throw Error(ErrorCode::UnusableInput,
                "the plane passes between the bodies of the part and cuts none"_text, {},
                "move the plane into a body, or split the part into its bodies"_text);
  std::vector<bool> isSection(cut.below.tag.size());
  for (std::size_t t = 0; t < isSection.size(); ++t)
    isSection[t] = cut.below.tag[t] >= 0;
  out.section = geometry::subMesh(cut.below.mesh, isSection);
  requireThickness(out.halves.below, cut.offsetMm, -plane.normal, out.section);
  requireThickness(out.halves.above, -cut.offsetMm, plane.normal, out.section);
  return out;
}

void addPins(const TriangleMesh& part, Halves& cut, const Joint& joint,
             const base::RunContext& ctx) {
  const double radius = 0.5 * joint.sizeMm, depth = joint.depthMm;
  const double holeRadius = radius + joint.clearanceMm, holeDepth = depth + joint.clearanceMm;
  const Vector3d& normal = cut.plane.normal;
  PartHalves& halves = cut.halves;
  halves.pins = pinPlaces(part, cut.section, cut.plane,
                          {holeRadius, holeDepth, wallMm(joint), std::max(1, joint.count)});
  if (halves.pins.empty())
    throw Error(ErrorCode::UnusableInput,
                base::message("no room in the section for a pin of {diameter}, {depth} deep"_text,
                              base::mm(joint.sizeMm), base::mm(depth)),
                {}, "choose a smaller pin or another plane"_text);
  const double chamfer = std::min(kChamferShare * joint.sizeMm, 0.3 * depth);
  const double beyond = wallMm(joint); // past the plane, where the half has no material
  const double whole = geometry::volume(part);
  for (const Vector3d& at : halves.pins) {
    ctx.checkpoint();
    const double above = geometry::volume(halves.above), below = geometry::volume(halves.below);
    const auto hole = [&](double from, double to) {
      return turned(at, normal, {{from, holeRadius}, {to, holeRadius}});
    };
    const double holeMm3 = geometry::volume(hole(0.0, holeDepth));
    halves.above =
        combinedOrFail(BooleanOperation::Difference, halves.above, hole(-beyond, holeDepth));
    requireVolume(halves.above, above - holeMm3, whole);
    if (joint.kind == Joint::Kind::Dowels) {
      halves.below =
          combinedOrFail(BooleanOperation::Difference, halves.below, hole(-holeDepth, beyond));
      requireVolume(halves.below, below - holeMm3, whole);
      halves.dowels.push_back(turned(at, normal,
                                     {{-depth, radius - chamfer},
                                      {chamfer - depth, radius},
                                      {depth - chamfer, radius},
                                      {depth, radius - chamfer}}));
      continue;
    }
    const std::vector<PinEnd> tip{{depth - chamfer, radius}, {depth, radius - chamfer}};
    const TriangleMesh peg =
        turned(at, normal, {{-std::min(beyond, depth), radius}, tip[0], tip[1]});
    const double outside = geometry::volume(turned(at, normal, {{0.0, radius}, tip[0], tip[1]}));
    halves.below = combinedOrFail(BooleanOperation::Union, halves.below, peg);
    requireVolume(halves.below, below + outside, whole);
  }
}

// Extrudes a profile in the plane of `side` and the normal. `cap`: its triangles, in its direction.
TriangleMesh extruded(const std::vector<Vector2d>& profile,
                      const std::vector<std::array<int, 3>>& cap, const Vector3d& at,
                      const Vector3d& side, const Vector3d& normal, double halfMm) {
  const Vector3d along = normal.cross(side);
  TriangleMesh mesh;
  for (const double end : {-halfMm, halfMm})
    for (const Vector2d& p : profile)
      mesh.vertices.push_back(at + p.x() * side + p.y() * normal + end * along);
  const int n = static_cast<int>(profile.size());
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    mesh.triangles.push_back({k, next, n + next});
    mesh.triangles.push_back({k, n + next, n + k});
  }
  for (const auto& t : cap) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
    mesh.triangles.push_back({n + t[0], n + t[1], n + t[2]});
  }
  if (geometry::volume(mesh) < 0.0)
    for (auto& t : mesh.triangles)
      std::swap(t[1], t[2]);
  return mesh;
}

// The range of a mesh along a direction.
std::pair<double, double> range(const TriangleMesh& mesh, const Vector3d& direction) {
  std::pair<double, double> out{1e300, -1e300};
  for (const Vector3d& v : mesh.vertices) {
    out.first = std::min(out.first, direction.dot(v));
    out.second = std::max(out.second, direction.dot(v));
  }
  return out;
}

[[noreturn]] void noRoomForDovetail(const Joint& joint) {
  throw Error(ErrorCode::UnusableInput,
              base::message("no room in the section for a dovetail of {width}, {height} high"_text,
                            base::mm(joint.sizeMm), base::mm(joint.depthMm)),
              {}, "choose a smaller dovetail, another direction or another plane"_text);
}

// Returns the connected part of the section with the largest area.
TriangleMesh largestOf(const TriangleMesh& section) {
  const geometry::Components parts = geometry::components(section);
  std::vector<double> mm2(static_cast<std::size_t>(parts.count));
  for (std::size_t t = 0; t < section.triangles.size(); ++t)
    mm2[static_cast<std::size_t>(parts.ofTriangle[t])] += geometry::triangleArea(section, t);
  const auto largest = static_cast<int>(std::ranges::max_element(mm2) - mm2.begin());
  std::vector<bool> keep(section.triangles.size());
  for (std::size_t t = 0; t < keep.size(); ++t)
    keep[t] = parts.ofTriangle[t] == largest;
  return geometry::subMesh(section, keep);
}

// Both halves are the part within a large body that has the joint on one side.
void addDovetail(const TriangleMesh& part, Halves& cut, const Joint& joint,
                 const base::RunContext& ctx) {
  const PlaneFrame axes = jointAxes(cut.plane.normal);
  const Vector3d& normal = cut.plane.normal;
  const Vector3d along =
      std::cos(joint.directionRad) * axes.across + std::sin(joint.directionRad) * axes.along;
  const Vector3d side = along.cross(normal);
  const TriangleMesh section = largestOf(cut.section);
  const Vector3d middle = centroidOf(section);
  const double neck = 0.5 * joint.sizeMm, height = joint.depthMm, wall = wallMm(joint);
  const double gap = joint.clearanceMm, slope = std::tan(kFlankRad);
  const double tip = neck + slope * height, aside = side.dot(middle);
  // Perpendicular to the flanks, like everywhere.
  const double gapAside = gap / std::cos(kFlankRad);
  const auto [low, high] = range(section, side);
  const double top = range(cut.halves.above, normal).second - cut.plane.offsetMm;
  if (aside - tip - gapAside - wall < low || aside + tip + gapAside + wall > high ||
      height + gap + wall > top)
    noRoomForDovetail(joint);
  const double far = 2.0 * geometry::bounds(part).diagonal().norm() + tip;
  const auto tongue = [&](double wider, double higher) {
    const double tipWider = wider + slope * higher;
    return std::vector<Vector2d>{{neck + wider, 0.0},
                                 {tip + tipWider, height + higher},
                                 {-tip - tipWider, height + higher},
                                 {-neck - wider, 0.0}};
  };
  const auto body = [&](const std::vector<Vector2d>& t, bool isBelow) {
    const double end = isBelow ? -far : far;
    const std::vector<Vector2d> profile{{-far, end}, {far, end}, {far, 0.0}, t[0],
                                        t[1],        t[2],       t[3],       {-far, 0.0}};
    // Of the lower body the tongue is added, of the upper one it is left out.
    const std::vector<std::array<int, 3>> cap =
        isBelow ? std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 6},
                                                  {0, 6, 7}, {3, 4, 5}, {3, 5, 6}}
                : std::vector<std::array<int, 3>>{{0, 6, 7}, {0, 5, 6}, {0, 4, 5},
                                                  {0, 1, 4}, {1, 3, 4}, {1, 2, 3}};
    return extruded(profile, cap, middle, side, normal, far);
  };
  PartHalves& halves = cut.halves;
  const double whole = geometry::volume(part);
  const double below = geometry::volume(halves.below), above = geometry::volume(halves.above);
  // Also past the plane, where the upper half has no material.
  const auto prism = [&](const std::vector<Vector2d>& t) {
    const std::vector<Vector2d> profile{
        {t[3].x(), -wall}, {t[0].x(), -wall}, t[0], t[1], t[2], t[3]};
    return extruded(profile, {{0, 1, 2}, {0, 2, 5}, {2, 3, 4}, {2, 4, 5}}, middle, side, normal,
                    far);
  };
  const auto within = [&](const std::vector<Vector2d>& t) {
    const auto shared =
        geometry::meshBoolean(BooleanOperation::Intersection, halves.above, prism(t), true);
    if (!shared)
      failsToJoin();
    if (shared->empty()) // around a hole
      noRoomForDovetail(joint);
    return geometry::volume(*shared);
  };
  const auto own = tongue(0.0, 0.0), groove = tongue(gapAside, gap);
  const double tongueMm3 = within(own), grooveMm3 = gap > 0.0 ? within(groove) : tongueMm3;
  ctx.checkpoint();
  halves.below = combinedOrFail(BooleanOperation::Intersection, part, body(own, true));
  requireVolume(halves.below, below + tongueMm3, whole);
  ctx.checkpoint();
  halves.above = combinedOrFail(BooleanOperation::Intersection, part, body(groove, false));
  requireVolume(halves.above, above - grooveMm3, whole);
}

} // namespace

PartHalves cutPart(const TriangleMesh& part, const Plane& plane, const Joint& joint,
                   const base::RunContext& ctx) {
  base::require(std::isfinite(plane.offsetMm) && std::abs(plane.normal.norm() - 1.0) < 1e-6 &&
                    std::isfinite(joint.sizeMm) && std::isfinite(joint.depthMm) &&
                    joint.clearanceMm >= 0.0,
                "cutPart: a plane and a joint of finite sizes");
  if (part.empty() || !isClosed(part))
    throw Error(ErrorCode::UnusableInput, "the part is not closed"_text, {},
                "repair the part first"_text);
  Halves cut = cutPlain(part, plane);
  ctx.checkpoint();
  if (joint.kind == Joint::Kind::Dowels || joint.kind == Joint::Kind::Pegs)
    addPins(part, cut, joint, ctx);
  else if (joint.kind == Joint::Kind::Dovetail)
    addDovetail(part, cut, joint, ctx);
  return std::move(cut.halves);
}

std::vector<TriangleMesh> bodiesOf(const TriangleMesh& mesh) {
  std::vector<TriangleMesh> bodies;
  for (TaggedMesh& solid : solids(tagged(mesh)))
    bodies.push_back(std::move(solid.mesh));
  return bodies;
}

} // namespace voluta::planar
