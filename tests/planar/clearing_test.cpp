// Cuts that gain nothing themselves: a body that hides a piece from the head is printed after it.
#include "helpers/shapes.h"
#include "planar/hand_parts.h"
#include "planar/head_reach.h"
#include "planar/piece_cut.h"
#include "planar/piece_order.h"
#include "planar/plan_check_of.h"
#include "planar/plan_checker.h"
#include "planar/plate_contact.h"
#include "planar/search/beam_search.h"
#include "process/process.h"

#include <gtest/gtest.h>

#include <random>

namespace voluta::planar {
namespace {

using Eigen::Vector3d;

process::HeadShape head() {
  return process::erodedHead(process::loadProcess("fdm-1.0").head, 0.4);
}

// A post with an arm that leans out by 60 degrees and ends before a wall: the wall prints upwards
// by itself, and blocks a head that prints the arm from its side.
geometry::TriangleMesh armBeforeWall() {
  return test::extruded({{-10, 0},
                         {60, 0},
                         {60, 130},
                         {50, 130},
                         {50, 6},
                         {10, 6},
                         {10, 50},
                         {35, 64.5},
                         {35, 72},
                         {-10, 72}},
                        -30, 30);
}

PlanarOptions optionsWithHead() {
  PlanarOptions options;
  options.head = head();
  options.keptContact = 1.0; // not all of it on its side
  return options;
}

TEST(Clearing, WallThatHidesAnArmIsPrintedAfterIt) {
  const geometry::TriangleMesh part = armBeforeWall();
  const PlanarOptions options = optionsWithHead();
  const PlanarDecomposition d = beamDecompose(part, options, base::RunContext({}, 2));
  EXPECT_GT(d.riskyBeforeMm2, 200.0);
  EXPECT_EQ(d.riskyMm2, 0.0);
  EXPECT_EQ(d.blockedPieces, 0U);
  // By hand: the post with the foot of the wall, the arm, and the rest of the wall.
  ASSERT_EQ(d.pieces.size(), 3U);
  EXPECT_GT(d.pieces[1].base.normal.x(), 0.2); // by 16 degrees at least
  EXPECT_GT(d.pieces[2].base.normal.z(), 0.7);
  EXPECT_NEAR(geometry::bounds(d.pieces[2].solid.mesh).max().z(), 130.0, 1e-9);

  const test::PlanCheck check = test::checkOf(d.pieces, options);
  const test::PlanVerdict verdict = test::checkPlan(part, d.pieces, check);
  EXPECT_TRUE(verdict.faults.empty());
  EXPECT_EQ(verdict.blockedPieces, 0U);
  EXPECT_EQ(verdict.riskyMm2, 0.0);
}

TEST(Clearing, WithoutAHeadItIsCutOffAtOnce) {
  PlanarOptions options = optionsWithHead();
  options.head = {};
  const PlanarDecomposition d = beamDecompose(armBeforeWall(), options, base::RunContext({}, 2));
  EXPECT_EQ(d.riskyMm2, 0.0);
  EXPECT_EQ(d.pieces.size(), 2U);
}

// Against every tip with every obstacle.
TEST(HeadReach, InsideAreTheObstaclesThatAnyTipMeets) {
  const HeadReach reach(head());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-30.0, 30.0);
  const Vector3d direction = Vector3d(0.3, -0.5, 0.8).normalized();
  std::vector<Vector3d> tips, obstacles;
  for (int i = 0; i < 40; ++i)
    tips.emplace_back(at(random), at(random), at(random));
  for (int i = 0; i < 800; ++i)
    obstacles.emplace_back(2.0 * at(random), 2.0 * at(random), 2.0 * at(random));
  const double lowest = -5.0;
  std::vector<Vector3d> expected;
  for (const Vector3d& o : obstacles)
    for (const Vector3d& t : tips)
      if (reach.blocked({t}, {std::vector<Eigen::Vector3d>{o}}, direction, lowest)) {
        expected.push_back(o);
        break;
      }
  EXPECT_GT(expected.size(), 50U);
  EXPECT_LT(expected.size(), 750U);
  EXPECT_EQ(reach.inside(tips, {obstacles}, direction, lowest), expected);
}

TEST(PrintOrder, FindsPiecesPrintedTooEarly) {
  // 1 and 2 rest on 0; each hides the other.
  const PieceOrder order = orderOf({kPlate, 0, 1}, {{0, 1}, {}, {}},
                                   [](std::size_t i, std::size_t j) { return i + j == 3; });
  EXPECT_EQ(order.blocked, 1U);
  ASSERT_EQ(order.late.size(), 1U);
  EXPECT_EQ(order.late.front().first + order.late.front().second, 3U);
  EXPECT_EQ(order.late.front().first, order.order.back());
}

// Of two towers on a bar only the given one is cut off, at the same plane.
TEST(CutOffAt, TakesTheSolidsWhoseSectionsAreMeant) {
  const geometry::TriangleMesh part = test::extruded(
      {{-20, 0}, {20, 0}, {20, 30}, {10, 30}, {10, 10}, {-10, 10}, {-10, 30}, {-20, 30}}, -5, 5);
  const Piece piece = wholePart(part, {});
  const Plane plane{Vector3d::UnitZ(), 20.0};
  const auto cut = cutOffAt(piece, plane, 7, {Vector3d(15.0, 1.0, 20.0)}, {});
  ASSERT_TRUE(cut);
  ASSERT_EQ(cut->above.size(), 1U);
  EXPECT_NEAR(geometry::volume(cut->above[0].solid.mesh), 10.0 * 10.0 * 10.0, 1e-9);
  EXPECT_GT(geometry::bounds(cut->above[0].solid.mesh).min().x(), 9.0);
  EXPECT_FALSE(cutOffAt(piece, plane, 7, {Vector3d(0.0, 0.0, 20.0)}, {}));
}

} // namespace
} // namespace voluta::planar
