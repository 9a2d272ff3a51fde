// Parts cut in two, with and without joints, and split into bodies.
#include "planar/parting/part_cut.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "geometry/repair/diagnosis.h"
#include "helpers/all_seeds.h"
#include "helpers/models.h"
#include "helpers/shapes.h"
#include "planar/plane_cut.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace voluta::planar {
namespace {

using Eigen::Vector3d;
using geometry::TriangleMesh;
using test::append;
using test::box;
using test::sphere;

constexpr int kPinSides = 48;

// Area of the polygon with that circumscribed radius.
double pinAreaMm2(double radius) {
  return 0.5 * kPinSides * radius * radius * std::sin(base::kTwoPi / kPinSides);
}
double frustumMm3(double from, double to, double height) {
  return height / 3.0 *
         (pinAreaMm2(from) + pinAreaMm2(to) + std::sqrt(pinAreaMm2(from) * pinAreaMm2(to)));
}

TriangleMesh cylinder(double radius, double height, int sides) {
  TriangleMesh mesh;
  for (const double z : {0.0, height})
    for (int k = 0; k < sides; ++k)
      mesh.vertices.emplace_back(radius * std::cos(base::kTwoPi * k / sides),
                                 radius * std::sin(base::kTwoPi * k / sides), z);
  for (int k = 0; k < sides; ++k) {
    const int next = (k + 1) % sides;
    mesh.triangles.push_back({k, next, sides + next});
    mesh.triangles.push_back({k, sides + next, sides + k});
    if (k > 0 && k + 1 < sides) {
      mesh.triangles.push_back({0, k + 1, k});
      mesh.triangles.push_back({sides, sides + k, sides + k + 1});
    }
  }
  return mesh;
}

PartHalves halvesOf(const TriangleMesh& part, const Plane& plane, const Joint& joint = {}) {
  PartHalves halves = cutPart(part, plane, joint, {});
  EXPECT_TRUE(isClosed(halves.below));
  EXPECT_TRUE(isClosed(halves.above));
  EXPECT_GT(geometry::volume(halves.below), 0.0);
  EXPECT_GT(geometry::volume(halves.above), 0.0);
  if (joint.kind == Joint::Kind::None) {
    EXPECT_NEAR(geometry::volume(halves.below) + geometry::volume(halves.above),
                geometry::volume(part), 1e-9 * geometry::volume(part));
  }
  return halves;
}

std::string failure(const TriangleMesh& part, const Plane& plane, const Joint& joint = {}) {
  try {
    cutPart(part, plane, joint, {});
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ErrorCode::UnusableInput);
    EXPECT_FALSE(error.remedy().empty());
    return error.what();
  }
  return {};
}

bool contains(const std::string& text, const char* words) {
  return text.find(words) != std::string::npos;
}

TEST(PartCut, VolumesOfABoxACylinderAndABall) {
  const PartHalves boxes = halvesOf(box({0, 0, 0}, {20, 30, 40}), {Vector3d::UnitY(), 12.0});
  EXPECT_NEAR(geometry::volume(boxes.below), 20 * 12 * 40, 1e-9);
  EXPECT_NEAR(geometry::volume(boxes.above), 20 * 18 * 40, 1e-9);
  EXPECT_NEAR(boxes.sectionMm2, 800.0, 1e-9);
  const TriangleMesh round = cylinder(10.0, 30.0, 720);
  const PartHalves lengths = halvesOf(round, {Vector3d::UnitZ(), 7.5});
  EXPECT_NEAR(geometry::volume(lengths.below), 0.25 * geometry::volume(round), 1e-6);
  EXPECT_NEAR(lengths.sectionMm2, base::kPi * 100.0, 0.01);
  const double h = 6.0, r = 20.0; // cap of a ball: pi h^2 (3 r - h) / 3
  const PartHalves ball = halvesOf(sphere({1, 2, 3}, r, 160), {Vector3d::UnitZ(), 3.0 + r - h});
  const double cap = base::kPi * h * h * (3.0 * r - h) / 3.0;
  EXPECT_NEAR(geometry::volume(ball.above), cap, 0.002 * cap);
}

TEST(PartCut, PlanesThatMissTouchOrFollowAFaceDoNotCut) {
  const TriangleMesh cube = box({0, 0, 0}, {10, 10, 10});
  for (const double at : {-5.0, 0.0, 10.0, 15.0})
    EXPECT_TRUE(contains(failure(cube, {Vector3d::UnitZ(), at}), "the plane does not cut the part"))
        << at;
  EXPECT_TRUE(contains(failure(cube, {Vector3d(1, 1, 1).normalized(), 0.0}), "does not cut"))
      << "touches a corner";
  // Through corners and edges it cuts.
  const PartHalves wedges = halvesOf(cube, {Vector3d(1, -1, 0).normalized(), 0.0});
  EXPECT_NEAR(geometry::volume(wedges.below), 500.0, 1e-9);
}

TEST(PartCut, SlabsThatCannotBePrintedAreRefused) {
  const TriangleMesh cube = box({0, 0, 0}, {10, 10, 10});
  const std::string above = failure(cube, {Vector3d::UnitZ(), 9.99});
  EXPECT_TRUE(contains(above, "a slab of 0.01 mm at (5, 5, 9.99), thinner than a layer")) << above;
  EXPECT_TRUE(contains(above, "move the plane")) << above;
  EXPECT_TRUE(contains(failure(cube, {Vector3d::UnitZ(), 0.04}), "a slab of 0.04 mm at"));
  EXPECT_TRUE(contains(failure(cube, {-Vector3d::UnitX(), -9.96}), "a slab of 0.04 mm at"));
  EXPECT_NEAR(geometry::volume(halvesOf(cube, {Vector3d::UnitZ(), 9.9}).above), 10.0, 1e-6);
  // Another body above makes the slab no thicker.
  TriangleMesh two = cube;
  append(two, box({0, 0, 12}, {10, 10, 20}));
  EXPECT_TRUE(contains(failure(two, {Vector3d::UnitZ(), 9.99}), "a slab of 0.01 mm"));
  EXPECT_EQ(bodiesOf(halvesOf(two, {Vector3d::UnitZ(), 6.0}).above).size(), 2u);
}

TEST(PartCut, PlanesBetweenBodiesCutNone) {
  TriangleMesh two = box({0, 0, 0}, {10, 10, 10});
  append(two, box({0, 0, 12}, {10, 10, 20}));
  for (const double at : {10.0, 11.0, 12.0}) {
    const std::string line = failure(two, {Vector3d::UnitZ(), at});
    EXPECT_TRUE(contains(line, "passes between the bodies of the part and cuts none")) << line;
    EXPECT_TRUE(contains(line, "split the part into its bodies")) << line;
  }
}

// The wall around a hole is thinnest at the rim of one of its ends, where the side leans inward.
TEST(PartCut, HolesLeaveTheirWallWhereTheSurfaceSlants) {
  const double height = 60.0, plane = 30.0;
  for (const double slantDeg : {2.0, 5.0, 10.0, 20.0, 30.0, 45.0})
    for (const double size : {3.0, 6.0, 9.0}) {
      SCOPED_TRACE(testing::Message() << slantDeg << " deg, " << size << " mm");
      // A ridge: its sides lean inward by the angle, and are 20 mm apart at the plane.
      const double slope = std::tan(base::degreesToRadians(slantDeg));
      const double foot = 20.0 + slope * plane, top = 20.0 - slope * (height - plane);
      TriangleMesh ridge = box({-foot, 0, 0}, {foot, 60, height});
      for (Vector3d& v : ridge.vertices)
        if (v.z() > 1.0)
          v.x() = std::copysign(std::max(top, 0.0), v.x());
      if (top <= 0.0)
        continue; // its sides meet below the top
      Joint joint;
      joint.kind = Joint::Kind::Dowels;
      joint.sizeMm = size;
      joint.count = 12; // also where there is least room
      const PartHalves halves = halvesOf(ridge, {Vector3d::UnitZ(), plane}, joint);
      const double radius = 0.5 * size + joint.clearanceMm,
                   depth = joint.depthMm + joint.clearanceMm;
      const double promised = std::max(1.2, 0.3 * size);
      ASSERT_FALSE(halves.pins.empty());
      for (const Vector3d& pin : halves.pins) {
        const double side = 20.0 - slope * depth; // half the width at the end of the hole
        const double wall =
            (side - std::abs(pin.x()) - radius) * std::cos(base::degreesToRadians(slantDeg));
        EXPECT_GE(wall, promised - 1e-9) << pin.x();
        EXPECT_GE(std::min(pin.y(), 60.0 - pin.y()) - radius, promised - 1e-9);
      }
    }
}

TEST(PartCut, AnOpenMeshIsRefused) {
  TriangleMesh open = box({0, 0, 0}, {10, 10, 10});
  open.triangles.pop_back();
  EXPECT_TRUE(contains(failure(open, {Vector3d::UnitZ(), 5.0}), "the part is not closed"));
  EXPECT_TRUE(contains(failure({}, {Vector3d::UnitZ(), 5.0}), "the part is not closed"));
}

TEST(PartCut, SeveralSectionsAndHoles) {
  TriangleMesh prongs = box({0, 0, 0}, {4, 10, 30});
  append(prongs, box({10, 0, 0}, {14, 10, 30}));
  const PartHalves halves = halvesOf(prongs, {Vector3d::UnitZ(), 10.0});
  EXPECT_EQ(bodiesOf(halves.above).size(), 2u);
  EXPECT_NEAR(halves.sectionMm2, 80.0, 1e-9);
  TriangleMesh hollow = sphere({0, 0, 0}, 12.0, 32);
  append(hollow, sphere({0, 0, 0}, 7.0, 32), true);
  const PartHalves bowls = halvesOf(hollow, {Vector3d::UnitX(), 0.0});
  EXPECT_NEAR(bowls.sectionMm2, base::kPi * (144.0 - 49.0), 2.0);
}

TEST(PartCut, DowelsHaveHolesInBothHalves) {
  const TriangleMesh part = box({0, 0, 0}, {60, 30, 50});
  Joint joint;
  joint.kind = Joint::Kind::Dowels;
  const PartHalves halves = halvesOf(part, {Vector3d::UnitZ(), 20.0}, joint);
  ASSERT_EQ(halves.pins.size(), 2u);
  ASSERT_EQ(halves.dowels.size(), 2u);
  const double hole = pinAreaMm2(3.15) * 8.15;
  EXPECT_NEAR(geometry::volume(halves.below), 60 * 30 * 20 - 2.0 * hole, 1e-6);
  EXPECT_NEAR(geometry::volume(halves.above), 60 * 30 * 30 - 2.0 * hole, 1e-6);
  const double dowel = pinAreaMm2(3.0) * 14.8 + 2.0 * frustumMm3(2.4, 3.0, 0.6);
  for (const TriangleMesh& loose : halves.dowels) {
    EXPECT_TRUE(isClosed(loose));
    EXPECT_NEAR(geometry::volume(loose), dowel, 1e-6);
    // It fits: in no half.
    const geometry::MeshQuery below(halves.below), above(halves.above);
    for (const Vector3d& v : loose.vertices) {
      EXPECT_FALSE(below.inside(v));
      EXPECT_FALSE(above.inside(v));
    }
  }
  for (const Vector3d& pin : halves.pins) {
    EXPECT_NEAR(pin.z(), 20.0, 1e-9);
    EXPECT_GT(std::min({pin.x(), 60 - pin.x(), pin.y(), 30 - pin.y()}), 3.15 + 1.2);
  }
  EXPECT_GT((halves.pins[0] - halves.pins[1]).norm(), 25.0) << "far from each other";
}

TEST(PartCut, PegsAreOfTheLowerHalf) {
  const TriangleMesh part = box({0, 0, 0}, {40, 40, 40});
  Joint joint;
  joint.kind = Joint::Kind::Pegs;
  joint.count = 3;
  joint.clearanceMm = 0.2;
  const PartHalves halves = halvesOf(part, {Vector3d::UnitX(), 15.0}, joint);
  EXPECT_EQ(halves.pins.size(), 3u);
  EXPECT_TRUE(halves.dowels.empty());
  EXPECT_EQ(bodiesOf(halves.below).size(), 1u);
  const double peg = pinAreaMm2(3.0) * 7.4 + frustumMm3(3.0, 2.4, 0.6);
  EXPECT_NEAR(geometry::volume(halves.below), 15 * 1600 + 3 * peg, 1e-5);
  EXPECT_NEAR(geometry::volume(halves.above), 25 * 1600 - 3 * pinAreaMm2(3.2) * 8.2, 1e-5);
  EXPECT_NEAR(geometry::bounds(halves.below).max().x(), 23.0, 1e-9);
}

TEST(PartCut, ADovetailIsATongueInAGroove) {
  const TriangleMesh part = box({0, 0, 0}, {50, 30, 40});
  Joint joint;
  joint.kind = Joint::Kind::Dovetail;
  joint.sizeMm = 10.0;
  joint.depthMm = 6.0;
  joint.clearanceMm = 0.0;
  const double tip = 10.0 + 2.0 * 6.0 * std::tan(base::kPi / 12.0);
  for (const bool alongX : {true, false}) {
    joint.directionRad = alongX ? 0.0 : 0.5 * base::kPi;
    const double length = alongX ? 50.0 : 30.0;
    const PartHalves halves = halvesOf(part, {Vector3d::UnitZ(), 18.0}, joint);
    const double tongue = 0.5 * (10.0 + tip) * 6.0 * length;
    EXPECT_NEAR(geometry::volume(halves.below), 50 * 30 * 18 + tongue, 1e-5);
    EXPECT_NEAR(geometry::volume(halves.below) + geometry::volume(halves.above), 60000.0, 1e-5);
  }
  joint.clearanceMm = 0.2;
  const PartHalves loose = halvesOf(part, {Vector3d::UnitZ(), 18.0}, joint);
  const double both = geometry::volume(loose.below) + geometry::volume(loose.above);
  const double aside = 0.2 / std::cos(base::kPi / 12.0);
  const double groove =
      0.5 * (10.0 + 2.0 * aside + tip + 2.0 * aside + 0.4 * std::tan(base::kPi / 12.0)) * 6.2;
  EXPECT_NEAR(both, 60000.0 - 30.0 * (groove - 0.5 * (10.0 + tip) * 6.0), 1e-4);
}

TEST(PartCut, WithoutRoomOneLineSaysSo) {
  Joint joint;
  joint.kind = Joint::Kind::Dowels;
  const TriangleMesh thin = box({0, 0, 0}, {40, 5, 40});
  EXPECT_TRUE(contains(failure(thin, {Vector3d::UnitZ(), 20.0}, joint),
                       "no room in the section for a pin of 6 mm, 8 mm deep"));
  EXPECT_TRUE(
      contains(failure(box({0, 0, 0}, {40, 40, 40}), {Vector3d::UnitZ(), 5.0}, joint), "no room"))
      << "the lower half is thinner than the hole is deep";
  joint.kind = Joint::Kind::Dovetail;
  EXPECT_TRUE(contains(failure(thin, {Vector3d::UnitZ(), 20.0}, joint),
                       "no room in the section for a dovetail"));
}

TEST(PartCut, FewerPinsWhereThereIsRoomForFewer) {
  Joint joint;
  joint.kind = Joint::Kind::Dowels;
  joint.count = 4;
  EXPECT_EQ(halvesOf(box({0, 0, 0}, {12, 12, 40}), {Vector3d::UnitZ(), 20.0}, joint).pins.size(),
            1u);
  TriangleMesh two = box({0, 0, 0}, {40, 40, 40});
  append(two, box({60, 0, 0}, {72, 12, 40}));
  EXPECT_EQ(halvesOf(two, {Vector3d::UnitZ(), 20.0}, joint).pins.size(), 5u)
      << "four in the larger section, one in the smaller";
}

TEST(PartCut, BodiesKeepTheirCavities) {
  TriangleMesh mesh = sphere({0, 0, 0}, 10.0);
  append(mesh, box({30, 0, 0}, {35, 5, 5}));
  append(mesh, sphere({0, 0, 0}, 6.0), true);
  append(mesh, sphere({0, 0, 0}, 3.0)); // loose in the cavity
  const std::vector<TriangleMesh> bodies = bodiesOf(mesh);
  ASSERT_EQ(bodies.size(), 3u);
  EXPECT_NEAR(geometry::volume(bodies[0]),
              geometry::volume(sphere({0, 0, 0}, 10.0)) - geometry::volume(sphere({0, 0, 0}, 6.0)),
              1e-9);
  EXPECT_NEAR(geometry::volume(bodies[1]), 125.0, 1e-9);
  double all = 0.0;
  for (const TriangleMesh& body : bodies)
    all += geometry::volume(body);
  EXPECT_NEAR(all, geometry::volume(mesh), 1e-9);
  EXPECT_EQ(bodiesOf(box({0, 0, 0}, {1, 1, 1})).size(), 1u);
  EXPECT_TRUE(bodiesOf({}).empty());
}

// Joints only move material between the halves, and leave their clearance.
TEST(PartCut, RandomPlanesAndJointsOfRandomParts) {
  const int cases = test::ofSeeds(24, 600);
  std::mt19937 random(77);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int cuts = 0, joined = 0;
  for (int seed = 0; seed < cases; ++seed) {
    TriangleMesh part = sphere({0, 0, 0}, 15.0 + 5.0 * unit(random), 6 + seed % 9);
    for (Vector3d& v : part.vertices)
      v.array() *= 1.0 + 0.15 * unit(random);
    if (seed % 3 == 0)
      append(part, box({40, -8, -8}, {60, 8, 8}));
    if (seed % 4 == 0)
      append(part, sphere({0, 0, 0}, 5.0, 8), true);
    const Vector3d normal = Vector3d(unit(random), unit(random), unit(random)).normalized();
    const Plane plane{normal, 7.0 * unit(random)};
    const double whole = geometry::volume(part);
    halvesOf(part, plane);
    ++cuts;
    Joint joint;
    joint.kind = static_cast<Joint::Kind>(1 + seed % 3);
    joint.sizeMm = 4.0;
    joint.depthMm = 4.0;
    joint.directionRad = base::kPi * unit(random);
    try {
      const PartHalves halves = halvesOf(part, plane, joint);
      ++joined;
      const double both = geometry::volume(halves.below) + geometry::volume(halves.above);
      EXPECT_LT(both, whole) << seed;
      EXPECT_GT(both, whole - 0.2 * whole - 2.0 * pinAreaMm2(2.15) * 8.3 * 4.0) << seed;
      for (const TriangleMesh* half : {&halves.below, &halves.above}) {
        EXPECT_TRUE(geometry::diagnose(*half).watertight) << seed;
        EXPECT_EQ(geometry::diagnose(*half).selfIntersections.count, 0u) << seed;
      }
    } catch (const base::Error& error) {
      EXPECT_TRUE(contains(error.what(), "no room")) << seed << ": " << error.what();
    }
  }
  EXPECT_GT(joined, cuts / 4);
}

class PartCutModels : public testing::TestWithParam<const char*> {};

TEST_P(PartCutModels, AreJoinedByEachKind) {
  VOLUTA_MODEL_OR_SKIP(file, GetParam());
  const TriangleMesh part = geometry::readMesh(file).mesh;
  ASSERT_TRUE(isClosed(part));
  const Eigen::AlignedBox3d bounds = geometry::bounds(part);
  const double size = bounds.sizes().minCoeff();
  int joined = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const auto kind : {Joint::Kind::Dowels, Joint::Kind::Pegs, Joint::Kind::Dovetail}) {
      Joint joint;
      joint.kind = kind;
      joint.sizeMm = joint.depthMm = 0.05 * size;
      joint.clearanceMm = 0.002 * size;
      try {
        halvesOf(part, {Vector3d::Unit(axis), bounds.center()[axis] + 0.01 * size}, joint);
        ++joined;
      } catch (const base::Error& error) {
        EXPECT_TRUE(contains(error.what(), "no room")) << error.what();
      }
    }
  EXPECT_GT(joined, 0);
}

INSTANTIATE_TEST_SUITE_P(Models, PartCutModels,
                         testing::Values("bunny_7k.stl", "fertility_9k.stl", "fandisk.stl"));

} // namespace
} // namespace voluta::planar
