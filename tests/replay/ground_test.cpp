// The ground under a first bead, and the nozzle's ways by joints: in closed form.
#include "replay/replay_ground.h"

#include "base/run_context.h"
#include "base/units.h"
#include "helpers/shapes.h"
#include "replay/depositor.h"
#include "replay/joint_arcs.h"
#include "replay/replay_scene.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta::replay {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using robot::JointVector;

TEST(GroundProbe, PlateIsDeepAndSlightlyWiderThanItsOutline) {
  const platform::PlatformSolid plate{{-10, -5}, {10, -5}, {10, 5}, {-10, 5}};
  const GroundProbe probe(plate);
  for (const double z : {0.0, -1.0, -1000.0}) {
    EXPECT_TRUE(probe.holds({0, 0, z}, 0.0));
    EXPECT_TRUE(probe.holds({10, 5, z}, 1e-9));
    for (const double over : {0.2, 0.4}) {
      EXPECT_EQ(probe.holds({10 + over, 0, z}, 0.3), over < 0.3);
      EXPECT_EQ(probe.holds({-10 - over, 0, z}, 0.3), over < 0.3);
      EXPECT_EQ(probe.holds({0, 5 + over, z}, 0.3), over < 0.3);
      EXPECT_EQ(probe.holds({0, -5 - over, z}, 0.3), over < 0.3);
    }
  }
  EXPECT_FALSE(probe.holds({0, 0, 0.01}, 1.0)) << "above it";
  EXPECT_FALSE(GroundProbe(platform::PlatformSolid{}).holds({0, 0, -1}, 1.0));
}

// A cylinder, then a cone, then another cylinder, about x.
platform::RodShape taperedRod(int sides) {
  platform::RodShape rod;
  rod.profile = {{-20, 4}, {0, 4}, {10, 2}, {10, 6}, {20, 6}};
  rod.sides = sides;
  return rod;
}
double rodRadius(double x) {
  return x < 0 ? 4.0 : x < 10 ? 4.0 - 0.2 * x : 6.0;
}

TEST(GroundProbe, ARodIsAsThickAsItsProfile) {
  platform::PlatformSolid round, hexagonal;
  round.rod = taperedRod(0);
  hexagonal.rod = taperedRod(6);
  const GroundProbe ofRound(round), ofHexagonal(hexagonal);
  std::mt19937 random(41);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int k = 0; k < 4000; ++k) {
    const Vector3d p(19.9 * u(random), 8 * u(random), 8 * u(random));
    const double radius = rodRadius(p.x()), away = p.tail<2>().norm();
    if (std::abs(p.x() - 10) < 1e-3)
      continue;
    EXPECT_EQ(ofRound.holds(p, 0.0), away <= radius);
    // Corners at radius, the first along y: inside all six sides, whose normals are between them.
    double out = -1e9;
    for (int side = 0; side < 6; ++side) {
      const double a = (side + 0.5) * base::kPi / 3.0;
      out = std::max(out, p.y() * std::cos(a) + p.z() * std::sin(a) -
                              radius * std::cos(base::kPi / 6.0));
    }
    if (std::abs(out) > 1e-5) {
      EXPECT_EQ(ofHexagonal.holds(p, 0.0), out < 0.0);
    }
  }
  // Over its ends by so much at most.
  for (const double over : {0.2, 0.4}) {
    EXPECT_EQ(ofRound.holds({20 + over, 0, 5.9}, 0.3), over < 0.3);
    EXPECT_EQ(ofRound.holds({-20 - over, 0, 3.9}, 0.3), over < 0.3);
    EXPECT_FALSE(ofRound.holds({-20 - over, 0, 4.1}, 0.3));
  }
}

TEST(GroundProbe, BodySupportsPointsInsideIt) {
  platform::PlatformSolid body;
  body.mesh = std::make_shared<const geometry::TriangleMesh>(test::box({-3, -2, 1}, {3, 2, 4}));
  const GroundProbe probe(body);
  EXPECT_TRUE(probe.holds({0, 0, 2}, 0.0));
  EXPECT_TRUE(probe.holds({2.9, -1.9, 3.9}, 0.0));
  EXPECT_FALSE(probe.holds({0, 0, 0.5}, 0.0));
  EXPECT_FALSE(probe.holds({3.1, 0, 2}, 0.0));
}

// A head beyond reach along outward() touches no solid: they end there, and nowhere before.
TEST(GroundSolids, ReachCoversTheSolids) {
  test::usesSourceTreeResources();
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::squarePlatform(30.0));
  const GroundSolids plate(test::squarePlatform(30.0), cell, 1.0, base::RunContext());
  EXPECT_NEAR(plate.reachMm(), 0.0, 1e-9);
  EXPECT_FALSE(plate.solids().empty());
  EXPECT_TRUE(plate.bodies().empty());
  EXPECT_EQ(plate.outward(Vector3d::UnitX()), Vector3d::UnitZ());

  const test::Scene scene = test::rodScene(1);
  for (const int sides : {0, 5}) {
    platform::PlatformSolid solid;
    solid.rod = taperedRod(sides);
    const GroundSolids rod(solid, scene.cell, 1.0, base::RunContext());
    EXPECT_NEAR(rod.reachMm(), 6.0, 1e-12);
    EXPECT_EQ(rod.solids().size(), 3u) << "the shoulder has no length";
    EXPECT_LT((rod.outward(Vector3d(0.3, 0.6, 0.8)) - Vector3d(0, 0.6, 0.8)).norm(), 1e-12);
    EXPECT_EQ(rod.outward(Vector3d::UnitX()), Vector3d::UnitZ());
    // Its solids are the rod: as far as the probe's, but that a cone with sides is the one within.
    const GroundProbe probe(solid);
    std::mt19937 random(42);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int k = 0; k < 1500; ++k) {
      const Vector3d p(22 * u(random), 8 * u(random), 8 * u(random));
      double nearest = 1e9;
      for (const PlacedShape& s : rod.solids())
        nearest = std::min(nearest, distanceToPoint(s.shape, s.work_T_shape.inverse() * p));
      const bool cone = sides > 0 && p.x() > 0 && p.x() < 10;
      if (nearest > 1e-4) {
        EXPECT_TRUE(cone || !probe.holds(p, 0.0));
      } else if (nearest == 0.0 && std::abs(p.x()) < 20) {
        EXPECT_TRUE(probe.holds(p, 1e-6));
      }
    }
  }
}

TEST(GroundSolids, ABodyIsItsCells) {
  test::usesSourceTreeResources();
  const process::Process process = process::loadProcess("fdm-1.0");
  platform::PlatformSolid body = test::squarePlatform(30.0);
  body.mesh = std::make_shared<const geometry::TriangleMesh>(test::box({-3, -2, 0}, {3, 2, 4}));
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, body);
  const GroundSolids ground(body, cell, 0.5, base::RunContext());
  ASSERT_EQ(ground.bodies().size(), 1u);
  EXPECT_TRUE(ground.bodies()[0].isPlatform);
  EXPECT_TRUE(GroundProbe(body).holds({0, 0, 3.0}, 0.0));
}

TEST(Depositor, ASectionIsAsWideAsItsVolumeOrACircle) {
  BeadPiece piece;
  piece.from = {0, 0, 0};
  piece.to = {2, 0, 0};
  piece.fromHeightMm = 0.6f;
  piece.toHeightMm = 1.0f;
  const double height = 0.8;
  for (const double width : {0.8, 1.2, 3.0, 5.5}) {
    const double area = width * height - (1.0 - 0.25 * base::kPi) * height * height;
    piece.volumeMm3 = static_cast<float>(2.0 * area);
    const BeadSection s = sectionOf(piece, 5.0);
    EXPECT_NEAR(s.widthMm, std::min(width, 5.0), 1e-5);
    EXPECT_NEAR(s.heightMm, height, 1e-6);
  }
  for (const double diameter : {0.2, 0.5, 0.79}) { // less than a round one as high
    piece.volumeMm3 = static_cast<float>(2.0 * 0.25 * base::kPi * diameter * diameter);
    const BeadSection s = sectionOf(piece, 5.0);
    EXPECT_NEAR(s.widthMm, diameter, 1e-5);
    EXPECT_NEAR(s.heightMm, diameter, 1e-5);
  }
  piece.volumeMm3 = 0.0f;
  EXPECT_EQ(sectionOf(piece, 5.0).widthMm, 0.0);
  piece.volumeMm3 = 1.0f;
  piece.to = piece.from;
  EXPECT_EQ(sectionOf(piece, 5.0).heightMm, 0.0) << "on the spot";
}

TEST(Depositor, AGridCoversItsBoxWithNoMoreCellsThanAllowed) {
  const Vector3d low(-3, 2, 0), high(7, 5.2, 1.1);
  const voxel::VoxelGrid fine = gridOver(low, high, 0.25, 1'000'000);
  EXPECT_EQ(fine.pitch, 0.25);
  EXPECT_EQ(fine.size, Eigen::Vector3i(40, 13, 5));
  EXPECT_EQ(fine.origin, low);
  const voxel::VoxelGrid coarse = gridOver(low, high, 0.25, 900);
  EXPECT_LE(coarse.cellCount(), 900u);
  EXPECT_GT(coarse.cellCount(), 450u) << "hardly coarser than it has to be";
  EXPECT_GE((coarse.pitch * coarse.size.cast<double>() - (high - low)).minCoeff(), -1e-9);
  const voxel::VoxelGrid flat = gridOver(low, low, 0.5, 10);
  EXPECT_EQ(flat.size, Eigen::Vector3i(1, 1, 1));
}

// On the way of a joint motion, beside it, and leaning from it.
TEST(JointArcs, PassWhereTheJointsTakeTheNozzle) {
  test::usesSourceTreeResources();
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::squarePlatform(30.0));
  plan::Trajectory t;
  t.dof = 6;
  JointVector q = cell.home();
  for (int i = 0; i < 3; ++i) {
    t.joints.insert(t.joints.end(), q.data(), q.data() + 6);
    t.timeS.push_back(i);
    t.move.push_back(i == 2 ? plan::MoveKind::Linear : plan::MoveKind::Joint);
    q[0] += 0.4;
    q[4] -= 0.3;
  }
  const auto at = [&](double u) {
    const JointVector a = Eigen::Map<const Eigen::VectorXd>(t.at(0), 6),
                      b = Eigen::Map<const Eigen::VectorXd>(t.at(1), 6);
    return cell.work_T_tool(a + u * (b - a));
  };
  JointArcs arcs(t, cell), tips(t, cell, false);
  for (const double u : {0.0, 0.013, 0.37, 0.5, 0.999, 1.0}) {
    const Isometry3d pose = at(u);
    const Vector3d tip = pose.translation(), direction = -pose.linear().col(2);
    EXPECT_TRUE(arcs.passes(1, tip, direction)) << u;
    EXPECT_FALSE(arcs.passes(0, tip, direction)) << "nothing leads there";
    EXPECT_FALSE(arcs.passes(2, tip, direction)) << "straight";
    EXPECT_FALSE(arcs.passes(3, tip, direction));
    const Vector3d along = (at(u + 1e-4).translation() - at(u - 1e-4).translation()).normalized();
    const Vector3d lateral = along.unitOrthogonal();
    for (const double mm : {0.24, 0.26})
      EXPECT_EQ(arcs.passes(1, tip + mm * lateral, direction), mm < 0.25) << u;
    const Vector3d axis = direction.unitOrthogonal();
    const Vector3d leaning = Eigen::AngleAxisd(0.05, axis) * direction;
    EXPECT_FALSE(arcs.passes(1, tip, leaning));
    EXPECT_TRUE(tips.passes(1, tip, leaning)) << "directions do not count";
    EXPECT_TRUE(arcs.passes(1, tip, Eigen::AngleAxisd(0.015, axis) * direction));
  }
  const Vector3d beyond = at(1.01).translation();
  EXPECT_GT((beyond - at(1.0).translation()).norm(), 0.3);
  EXPECT_FALSE(tips.passes(1, beyond, Vector3d::UnitZ()));
}

} // namespace
} // namespace voluta::replay
