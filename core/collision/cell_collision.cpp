#include "collision/cell_collision.h"

#include "base/error.h"
#include "collision/growing_part.h"
#include "collision/polyhedron_distance.h"
#include "collision/shape_distance.h"
#include "process/process.h"
#include "robot/cell.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

namespace voluta::collision {

using Eigen::Isometry3d;
using Eigen::Vector3d;

struct CellCollision::Solid {
  explicit Solid(const robot::Shape& s)
      : shape(s), placed(place(s, Isometry3d::Identity())), ball(boundingBall(placed)) {
    if (!std::holds_alternative<robot::Capsule>(s))
      polyhedron = std::make_unique<Polyhedron>(s);
  }
  robot::Shape shape;
  PlacedShape placed; // in the body's frame
  Ball ball;
  std::unique_ptr<Polyhedron> polyhedron; // none for capsules
};

struct CellCollision::Assembly {
  explicit Assembly(const std::vector<robot::Shape>& shapes) {
    Vector3d sum = Vector3d::Zero();
    for (const robot::Shape& s : shapes) {
      solids.emplace_back(s);
      sum += solids.back().ball.centre;
    }
    ball.centre = shapes.empty() ? sum : Vector3d(sum / static_cast<double>(shapes.size()));
    ball.radius = 0.0;
    for (const Solid& s : solids)
      ball.radius = std::max(ball.radius, (s.ball.centre - ball.centre).norm() + s.ball.radius);
  }
  std::vector<Solid> solids;
  Ball ball;
};

namespace {

// A direction in which solids of this kind are often separated: their axis.
Vector3d axisOf(const robot::Shape& shape) {
  if (const auto* f = std::get_if<robot::Frustum>(&shape))
    return (f->p1 - f->p0).normalized();
  if (const auto* b = std::get_if<robot::Box>(&shape))
    return b->frame_T_box.linear().col(2);
  return Vector3d::UnitZ();
}

// Returns the gap between the two along a direction of the base; a lower bound of their distance.
double gap(const robot::Shape& a, const Isometry3d& base_T_a, const robot::Shape& b,
           const Isometry3d& base_T_b, const Vector3d& direction) {
  const double reachA =
      support(a, base_T_a.linear().transpose() * direction) + base_T_a.translation().dot(direction);
  const double reachB = support(b, -(base_T_b.linear().transpose() * direction)) -
                        base_T_b.translation().dot(direction);
  return -reachA - reachB;
}

} // namespace

// A solid at its pose, with precomputed data for tests against others.
struct CellCollision::PosedSolid {
  PosedSolid(const Solid& s, const Isometry3d& pose)
      : solid(&s), base_T_solid(&pose), centre(pose * s.ball.centre) {
    if (const auto* capsule = std::get_if<robot::Capsule>(&s.shape)) {
      p0 = pose * capsule->p0;
      p1 = pose * capsule->p1;
    }
  }
  const Solid* solid;
  const Isometry3d* base_T_solid;
  Vector3d centre, p0, p1; // of its bounding sphere; of a capsule's segment
};

// The cell's bodies at a pose.
class CellCollision::PosedBodies {
public:
  PosedBodies(const CellCollision& cell, const Frames& base_T_frame) {
    bodies_.reserve(cell.assemblies_.size());
    solids_.reserve(cell.solidCount_);
    for (std::size_t i = 0; i < cell.assemblies_.size(); ++i) {
      const Assembly& assembly = cell.assemblies_[i];
      const Isometry3d& pose = base_T_frame[static_cast<std::size_t>(cell.cell_.bodies()[i].frame)];
      const std::size_t first = solids_.size();
      placeSolids(assembly, pose, solids_);
      bodies_.push_back(
          {pose * assembly.ball.centre, assembly.ball.radius, first, assembly.solids.size()});
    }
  }

  // Returns the distance of two of them, or a lower bound of it above `enough`.
  double distance(int a, int b, double enough) const {
    const Body &one = bodies_[static_cast<std::size_t>(a)],
               &other = bodies_[static_cast<std::size_t>(b)];
    const double balls = (one.centre - other.centre).norm() - one.radius - other.radius;
    return balls > enough ? balls : CellCollision::distance(solidsOf(one), solidsOf(other), enough);
  }

private:
  struct Body {
    Vector3d centre;
    double radius;
    std::size_t first, count; // of solids_
  };
  std::span<const PosedSolid> solidsOf(const Body& body) const {
    return std::span(solids_).subspan(body.first, body.count);
  }

  std::vector<Body> bodies_; // in the order of the cell's
  std::vector<PosedSolid> solids_;
};

CellCollision::CellCollision(const robot::Cell& cell, const process::Process& process)
    : cell_(cell), platformTopMm_(-std::numeric_limits<double>::infinity()) {
  const auto& bodies = cell.bodies();
  std::vector<int> platforms;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    assemblies_.emplace_back(bodies[i].shapes);
    solidCount_ += bodies[i].shapes.size();
    if (bodies[i].role == robot::BodyRole::Platform) {
      platforms.push_back(static_cast<int>(i));
      for (const robot::Shape& shape : bodies[i].shapes)
        platformTopMm_ = std::max(platformTopMm_, support(shape, Vector3d::UnitZ()));
    }
    if (bodies[i].role == robot::BodyRole::Holder && bodies[i].frame == cell.toolFrame())
      holders_.push_back(static_cast<int>(i));
  }
  for (const int i : platforms)
    placeSolids(assemblies_[static_cast<std::size_t>(i)], work_T_platform_, platformSolids_);
  std::ranges::copy_if(
      cell.checkedPairs(), std::back_inserter(freePairs_),
      [this](const auto& pair) { return !isHeadAndPlatform(pair.first, pair.second); });
  const process::HeadShape eroded = process::erodedHead(process.head, process.contactToleranceMm);
  std::vector<robot::Frustum> frusta;
  for (std::size_t i = 1; i < eroded.sections.size(); ++i) {
    const auto &a = eroded.sections[i - 1], &b = eroded.sections[i];
    if (b.zMm > a.zMm)
      frusta.push_back({Vector3d(0, 0, -a.zMm), Vector3d(0, 0, -b.zMm), a.radiusMm, b.radiusMm});
  }
  erodedHead_ = std::make_unique<Assembly>(std::vector<robot::Shape>(frusta.begin(), frusta.end()));
  revolvedHead_ = std::make_unique<Revolved>(frusta);
}

CellCollision::~CellCollision() = default;

double CellCollision::distance(const PosedSolid& a, const PosedSolid& b, double enough) {
  const double balls = (a.centre - b.centre).norm() - a.solid->ball.radius - b.solid->ball.radius;
  if (balls > enough)
    return balls;
  // The capsule is transformed into the other's frame, where that one is precomputed.
  const auto* capsuleA = std::get_if<robot::Capsule>(&a.solid->shape);
  const auto* capsuleB = std::get_if<robot::Capsule>(&b.solid->shape);
  if (capsuleA && capsuleB)
    return segmentDistance(a.p0, a.p1, b.p0, b.p1) - capsuleA->radius - capsuleB->radius;
  const auto within = [](const PosedSolid& solid, const Vector3d& point) -> Vector3d {
    return solid.base_T_solid->linear().transpose() * (point - solid.base_T_solid->translation());
  };
  if (capsuleA)
    return capsuleDistance({within(b, a.p0), within(b, a.p1), capsuleA->radius}, b.solid->placed,
                           enough);
  if (capsuleB)
    return capsuleDistance({within(a, b.p0), within(a, b.p1), capsuleB->radius}, a.solid->placed,
                           enough);

  const double lowerBound =
      signedDistance(b.solid->placed, within(b, a.centre)) - a.solid->ball.radius;
  if (lowerBound > enough)
    return lowerBound;
  const Isometry3d &base_T_a = *a.base_T_solid, &base_T_b = *b.base_T_solid;
  const Vector3d between = b.centre - a.centre;
  const Vector3d axisA = base_T_a.linear() * axisOf(a.solid->shape);
  const Vector3d axisB = base_T_b.linear() * axisOf(b.solid->shape);
  for (const Vector3d& direction : {between, axisA, axisB}) {
    const double length = direction.norm();
    if (length <= 0.0)
      continue;
    const Vector3d u = (direction.dot(between) < 0.0 ? -1.0 : 1.0) / length * direction;
    const double apart = gap(a.solid->shape, base_T_a, b.solid->shape, base_T_b, u);
    if (apart > enough)
      return apart;
  }
  return Polyhedron::distance(*a.solid->polyhedron, base_T_a, *b.solid->polyhedron, base_T_b);
}

double CellCollision::distance(std::span<const PosedSolid> a, std::span<const PosedSolid> b,
                               double enough) {
  double minimum = std::numeric_limits<double>::infinity();
  for (const PosedSolid& s : a)
    for (const PosedSolid& t : b)
      minimum = std::min(minimum, distance(s, t, std::min(enough, minimum)));
  return minimum;
}

void CellCollision::placeSolids(const Assembly& assembly, const Isometry3d& pose,
                                std::vector<PosedSolid>& to) {
  for (const Solid& solid : assembly.solids)
    to.emplace_back(solid, pose);
}

bool CellCollision::isHeadAndPlatform(int a, int b) const {
  using robot::BodyRole;
  const BodyRole roleA = cell_.bodies()[static_cast<std::size_t>(a)].role;
  const BodyRole roleB = cell_.bodies()[static_cast<std::size_t>(b)].role;
  return (roleA == BodyRole::Head && roleB == BodyRole::Platform) ||
         (roleA == BodyRole::Platform && roleB == BodyRole::Head);
}

std::optional<Contact> CellCollision::bodies(const Frames& base_T_frame,
                                             const Margins& margins) const {
  const PosedBodies posed(*this, base_T_frame);
  for (const auto& [a, b] : freePairs_)
    if (posed.distance(a, b, margins.bodiesMm) <= margins.bodiesMm)
      return Contact{a, b};
  const auto work = static_cast<std::size_t>(cell_.workFrame());
  const auto tool = static_cast<std::size_t>(cell_.toolFrame());
  if (headTouchesPlatform(base_T_frame[work].inverse(Eigen::Isometry) * base_T_frame[tool],
                          margins.headMm))
    for (const auto& [a, b] : cell_.checkedPairs())
      if (isHeadAndPlatform(a, b))
        return Contact{a, b};
  return std::nullopt;
}

// Calls visit(body, its index, work_T_body) for bodies that may collide with the part, except the
// head; stops if it returns true.
template <typename Visit>
void CellCollision::forBodiesAgainstPart(const Frames& base_T_frame, Visit&& visit) const {
  const Isometry3d work_T_base =
      base_T_frame[static_cast<std::size_t>(cell_.workFrame())].inverse(Eigen::Isometry);
  for (const int i : cell_.bodiesAgainstPart()) {
    const robot::Body& body = cell_.bodies()[static_cast<std::size_t>(i)];
    if (body.role != robot::BodyRole::Head &&
        visit(body, i, work_T_base * base_T_frame[static_cast<std::size_t>(body.frame)]))
      return;
  }
}

std::optional<Contact> CellCollision::bodiesAndPart(const Frames& base_T_frame,
                                                    const GrowingPart& part, std::size_t before,
                                                    const Margins& margins) const {
  std::optional<Contact> contact;
  forBodiesAgainstPart(base_T_frame, [&](const robot::Body& body, int i, const Isometry3d& pose) {
    for (const robot::Shape& shape : body.shapes)
      if (part.touches(shape, pose, margins.partMm, before)) {
        contact = Contact{i, kPrintedPart};
        return true;
      }
    return false;
  });
  return contact;
}

bool CellCollision::headTouchesPart(const Isometry3d& work_T_tool, const GrowingPart& part,
                                    std::size_t before, double marginMm,
                                    std::optional<std::size_t> printing) const {
  return part.headTouches(*revolvedHead_, work_T_tool, marginMm, before, printing);
}

bool CellCollision::touchesPlatform(const Assembly& assembly, const Isometry3d& work_T_assembly,
                                    double marginMm) const {
  // Fast path: usually all of it is above the plate.
  const Vector3d down = work_T_assembly.linear().transpose() * -Vector3d::UnitZ();
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Solid& solid : assembly.solids)
    deepest = std::max(deepest, support(solid.shape, down));
  if (work_T_assembly.translation().z() - deepest > platformTopMm_ + marginMm)
    return false;
  std::vector<PosedSolid> solids;
  placeSolids(assembly, work_T_assembly, solids);
  return distance(solids, platformSolids_, marginMm) <= marginMm;
}

bool CellCollision::holderTouches(const Isometry3d& work_T_tool, const GrowingPart& part,
                                  std::size_t before, const Margins& margins) const {
  return std::ranges::any_of(holders_, [&](int h) {
    const Assembly& holder = assemblies_[static_cast<std::size_t>(h)];
    return std::ranges::any_of(holder.solids,
                               [&](const Solid& solid) {
                                 return part.touches(solid.shape, work_T_tool, margins.partMm,
                                                     before);
                               }) ||
           touchesPlatform(holder, work_T_tool, margins.bodiesMm);
  });
}

bool CellCollision::headTouchesPlatform(const Isometry3d& work_T_tool, double marginMm) const {
  return touchesPlatform(*erodedHead_, work_T_tool, marginMm);
}

std::optional<Contact> CellCollision::any(const Frames& base_T_frame, const GrowingPart& part,
                                          std::size_t before, const Margins& margins) const {
  const Isometry3d work_T_tool =
      base_T_frame[static_cast<std::size_t>(cell_.workFrame())].inverse(Eigen::Isometry) *
      base_T_frame[static_cast<std::size_t>(cell_.toolFrame())];
  if (headTouchesPart(work_T_tool, part, before, margins.headMm))
    for (const int i : cell_.bodiesAgainstPart())
      if (cell_.bodies()[static_cast<std::size_t>(i)].role == robot::BodyRole::Head)
        return Contact{i, kPrintedPart};
  if (const auto contact = bodies(base_T_frame, margins))
    return contact;
  return bodiesAndPart(base_T_frame, part, before, margins);
}

double CellCollision::clearance(const Frames& base_T_frame, double capMm,
                                std::size_t* nearest) const {
  const PosedBodies posed(*this, base_T_frame);
  double minimum = capMm;
  const auto look = [&](std::size_t pair) {
    const double distance =
        posed.distance(freePairs_[pair].first, freePairs_[pair].second, minimum);
    if (distance < minimum && nearest)
      *nearest = pair;
    minimum = std::min(minimum, distance);
  };
  // Start with the nearest pair: its distance prunes most of the others.
  const std::size_t first = nearest && *nearest < freePairs_.size() ? *nearest : 0;
  for (std::size_t pair = first; pair < freePairs_.size(); ++pair)
    look(pair);
  for (std::size_t pair = 0; pair < first; ++pair)
    look(pair);
  return minimum;
}

double CellCollision::clearanceToPart(const Frames& base_T_frame, const GrowingPart& part,
                                      std::size_t before, double capMm) const {
  double minimum = capMm;
  forBodiesAgainstPart(base_T_frame, [&](const robot::Body& body, int, const Isometry3d& pose) {
    for (const robot::Shape& shape : body.shapes)
      minimum = std::min(minimum, part.distance(shape, pose, minimum, before));
    return false;
  });
  return minimum;
}

std::vector<Contact> CellCollision::clearancePairs() const {
  std::vector<Contact> pairs;
  for (const auto& [a, b] : freePairs_)
    pairs.push_back({a, b});
  for (const int body : cell_.bodiesAgainstPart())
    if (cell_.bodies()[static_cast<std::size_t>(body)].role != robot::BodyRole::Head)
      pairs.push_back({body, kPrintedPart});
  return pairs;
}

double CellCollision::distanceBetween(const Assembly& first, const Isometry3d& common_T_first,
                                      const Assembly& second, const Isometry3d& common_T_second,
                                      double capMm) {
  const double balls =
      (common_T_first * first.ball.centre - common_T_second * second.ball.centre).norm() -
      first.ball.radius - second.ball.radius;
  if (balls > capMm)
    return balls;
  std::vector<PosedSolid> a, b;
  placeSolids(first, common_T_first, a);
  placeSolids(second, common_T_second, b);
  return distance(a, b, capMm);
}

double CellCollision::distanceOf(const Contact& pair, const Frames& base_T_frame,
                                 const GrowingPart& part, std::size_t before, double capMm) const {
  const auto poseOf = [&](int body) -> const Isometry3d& {
    return base_T_frame[static_cast<std::size_t>(
        cell_.bodies()[static_cast<std::size_t>(body)].frame)];
  };
  const Assembly& first = assemblies_[static_cast<std::size_t>(pair.first)];
  const Isometry3d& base_T_first = poseOf(pair.first);
  if (pair.second == kPrintedPart) {
    const Isometry3d work_T_first =
        base_T_frame[static_cast<std::size_t>(cell_.workFrame())].inverse(Eigen::Isometry) *
        base_T_first;
    double minimum = capMm;
    for (const Solid& solid : first.solids)
      minimum = std::min(minimum, part.distance(solid.shape, work_T_first, minimum, before));
    return minimum;
  }
  return distanceBetween(first, base_T_first, assemblies_[static_cast<std::size_t>(pair.second)],
                         poseOf(pair.second), capMm);
}

double CellCollision::distanceToOther(int body, const Isometry3d& common_T_body,
                                      const CellCollision& other, int otherBody,
                                      const Isometry3d& common_T_other, double capMm) const {
  const auto assemblyOf = [](const CellCollision& of, int i) -> const Assembly& {
    const bool isHead =
        of.cell_.bodies()[static_cast<std::size_t>(i)].role == robot::BodyRole::Head;
    return isHead ? *of.erodedHead_ : of.assemblies_[static_cast<std::size_t>(i)];
  };
  return distanceBetween(assemblyOf(*this, body), common_T_body, assemblyOf(other, otherBody),
                         common_T_other, capMm);
}

std::vector<robot::Shape> CellCollision::erodedHead() const {
  std::vector<robot::Shape> shapes;
  for (const Solid& solid : erodedHead_->solids)
    shapes.push_back(solid.shape);
  return shapes;
}

Ball CellCollision::ballAbout(int body) const {
  return assemblies_[static_cast<std::size_t>(body)].ball;
}

base::Value CellCollision::nameOf(int body) const {
  return body == kPrintedPart ? "printed part"_text
                              : robot::nameOf(cell_.bodies()[static_cast<std::size_t>(body)]);
}

} // namespace voluta::collision
