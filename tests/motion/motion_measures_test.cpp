// Small measures that the planners go by, each against its definition: external axes, deviation of
// the nozzle from its way, soft beads, surrounding beads, costs of joints, the final check.
#include "base/run_context.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "collision/way_clearance.h"
#include "motion/check.h"
#include "motion/external_axes.h"
#include "motion/head_refusals.h"
#include "motion/ladder/joint_costs.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "motion/motion_scene.h"
#include "motion/nozzle_frame.h"
#include "motion/sample_plans.h"
#include "motion/sequence.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

robot::Cell cellOf(const std::string& id) {
  platform::PlatformSolid plate;
  if (id == "lathe")
    plate.rod = platform::straightRod(5.0, 200.0);
  else
    plate.polygon = test::disc(20.0);
  return robot::loadCell(id, process::loadProcess("fdm-1.0"), plate);
}

JointVector anyAxes(const robot::Cell& cell, std::mt19937& random) {
  JointVector q = cell.home();
  for (int j = cell.armDof(); j < cell.dof(); ++j) {
    const robot::JointLimits& limit = cell.limits()[static_cast<std::size_t>(j)];
    q[j] = std::uniform_real_distribution<double>(std::max(limit.min, -500.0),
                                                  std::min(limit.max, 500.0))(random);
  }
  return q;
}

struct Scene {
  plan::ToolPlan plan;
  process::Process process = process::loadProcess("fdm-1.0");
  robot::Cell cell;
  collision::CellCollision collision{cell, process};
  collision::GrowingPart part;
  motion::MotionOptions options;
  motion::MotionScene scene{plan, cell, collision, part, options, motion::leversOf(plan, cell)};

  explicit Scene(plan::ToolPlan p, const std::string& id = "ur5-fixed")
      : plan(std::move(p)), cell(cellOf(id)), part(plan, 0.45, {}) {}
};

} // namespace

TEST(ExternalAxes, MoveTheWorkFrameAsTheCellDoes) {
  std::mt19937 random(51);
  std::uniform_real_distribution<double> u(-1, 1);
  for (const char* id : {"irb1200-irbp", "kr10-r1100-slide", "lathe"}) {
    const robot::Cell cell = cellOf(id);
    ASSERT_TRUE(cell.axesMovePlatform()) << id;
    const Isometry3d base_T_first = cell.externalAxes().front().before_T_axis;
    for (int round = 0; round < 30; ++round) {
      const JointVector q = anyAxes(cell, random), axes = motion::axesOf(cell, q);
      EXPECT_EQ(axes.size(), cell.dof() - cell.armDof());
      const Isometry3d first_T_work = base_T_first.inverse() * cell.base_T_work(q);
      const Vector3d p(50 * u(random), 50 * u(random), 50 * u(random));
      EXPECT_LT((motion::movedByAxes(cell, p, axes) - first_T_work * p).norm(), 1e-9) << id;
      EXPECT_LT((motion::turnedByAxes(cell, p, axes) - first_T_work.linear() * p).norm(), 1e-9);
      EXPECT_LT(motion::angleBetween(motion::axesRotation(cell, axes),
                                     Quaterniond(first_T_work.linear())),
                1e-7);
      // How the point moves by each axis, from a little less to a little more.
      const Vector3d inBase = cell.base_T_work(q) * p;
      const motion::AxisTwists twists = motion::axisTwists(cell, axes, inBase);
      ASSERT_EQ(twists.cols(), axes.size());
      for (Eigen::Index k = 0; k < axes.size(); ++k) {
        JointVector less = q, more = q;
        less[cell.armDof() + k] -= 1e-5;
        more[cell.armDof() + k] += 1e-5;
        const Isometry3d a = cell.base_T_work(less), b = cell.base_T_work(more);
        EXPECT_LT((twists.col(k).head<3>() - (b * p - a * p) / 2e-5).norm(), 1e-4) << id;
        const Eigen::AngleAxisd rotation(b.linear() * a.linear().transpose());
        EXPECT_LT((twists.col(k).tail<3>() - rotation.angle() / 2e-5 * rotation.axis()).norm(),
                  1e-4)
            << id;
      }
    }
  }
}

TEST(ExternalAxes, SnapToTheirStepsAndRestAtWholeTurns) {
  const robot::Cell lathe = cellOf("lathe");
  const robot::ExternalAxis& axis = lathe.externalAxes().front();
  ASSERT_GT(axis.step, 0.0);
  for (const double steps : {0.0, 3.4, 3.6, -7.4, -7.6}) {
    const JointVector q =
        motion::withAxes(lathe, lathe.home(), JointVector::Constant(1, axis.step * steps));
    EXPECT_NEAR(q[lathe.armDof()], axis.step * std::round(steps), 1e-12);
    EXPECT_EQ(q.head(lathe.armDof()), lathe.home().head(lathe.armDof()));
  }
  for (const double turns : {0.4, 0.6, 2.3, -3.7}) {
    JointVector q = lathe.home();
    q[0] += 0.3;
    q[lathe.armDof()] = base::kTwoPi * turns;
    const JointVector rest = motion::homeAfter(lathe, q);
    EXPECT_EQ(rest.head(lathe.armDof()), lathe.home().head(lathe.armDof()));
    const double wanted = axis.runsOn ? base::kTwoPi * std::round(turns) : 0.0;
    EXPECT_NEAR(rest[lathe.armDof()], wanted, 0.5 * axis.step + 1e-12);
  }
  const robot::Cell irbp = cellOf("irb1200-irbp");
  std::mt19937 random(52);
  const JointVector q = anyAxes(irbp, random), axes = motion::axesOf(irbp, q);
  ASSERT_EQ(axes.size(), 2);
  EXPECT_EQ(motion::withAxes(irbp, irbp.home(), axes), q) << "anywhere, and the arm as it was";
  EXPECT_EQ(motion::homeAfter(irbp, anyAxes(irbp, random)), irbp.home()) << "these unwind";
}

// With the plate on the flange the nozzle bends off its straight way on the part where the flange
// goes straight: by no more than the bound, and not far less in the worst case.
TEST(MotionScene, NozzleDeviationIsBoundedAndEachDivisionStaysNear) {
  Scene s(test::cylinder(10.0, 1));
  std::mt19937 random(53);
  std::uniform_real_distribution<double> u(-1, 1);
  double worst = 0.0;
  for (int round = 0; round < 400; ++round) {
    const Vector3d a = 100 * Vector3d(u(random), u(random), u(random)),
                   b = a + 6 * Vector3d(u(random), u(random), u(random));
    const Quaterniond from(
        Eigen::AngleAxisd(3 * u(random), Vector3d(1, u(random), 1).normalized()));
    const double angle = 0.15 * std::abs(u(random));
    const Quaterniond to =
        Quaterniond(Eigen::AngleAxisd(angle, Vector3d(u(random), u(random), 1).normalized())) *
        from;
    // The plate's poses relative to the fixed nozzle: straight and even.
    const auto farthest = [&](double t0, double t1) {
      const auto tool = [&](double t) {
        return motion::toolPose(a + t * (b - a), from.slerp(t, to));
      };
      const Isometry3d p = tool(t0).inverse(), q = tool(t1).inverse();
      double maximum = 0.0;
      for (int k = 1; k < 20; ++k) {
        const double t = k / 20.0;
        Isometry3d plate = Isometry3d::Identity();
        plate.translation() = (1 - t) * p.translation() + t * q.translation();
        plate.linear() =
            Quaterniond(p.linear()).slerp(t, Quaterniond(q.linear())).toRotationMatrix();
        const Vector3d start = tool(t0).translation(), end = tool(t1).translation();
        maximum =
            std::max(maximum, (plate.inverse().translation() - start - t * (end - start)).norm());
      }
      return maximum;
    };
    const double reported = s.scene.bend(a, b, angle), bends = farthest(0.0, 1.0);
    EXPECT_LE(bends, 1.02 * reported + 1e-9);
    worst = std::max(worst, bends / reported);
    const int n = s.scene.divisions(a, b, angle);
    ASSERT_GE(n, 1);
    EXPECT_LE(farthest(0.0, 1.0 / n), 1.02 * s.options.deviationMm + 1e-9);
    if (n > 1) {
      EXPECT_GT(reported, s.options.deviationMm * (n - 1) * (n - 1)) << "as few as will do";
    }
  }
  EXPECT_GT(worst, 0.6);
  Scene moving(test::cylinder(10.0, 1), "ur5-moving");
  EXPECT_EQ(moving.scene.bend({9, 0, 0}, {0, 9, 0}, 0.5), 0.0) << "its nozzle goes straight itself";
  EXPECT_EQ(moving.scene.divisions({9, 0, 0}, {0, 9, 0}, 0.5), 1);
}

TEST(MotionScene, StatesAreAsFarApartAsTheirLargestStep) {
  Scene s(test::cylinder(10.0, 1), "kr10-r1100-slide");
  JointVector a = s.cell.home(), b = a;
  b[1] += 0.2;
  b[4] -= 0.3;
  EXPECT_NEAR(s.scene.span(a, b), 0.3, 1e-12);
  b[6] += 20.0; // mm of the slide, a hundred of which are a radian
  EXPECT_NEAR(s.scene.span(a, b), 0.3, 1e-12);
  b[6] += 30.0;
  EXPECT_NEAR(s.scene.span(a, b), 0.5, 1e-12);
  EXPECT_NEAR(s.scene.span(b, a), 0.5, 1e-12);
}

// Two widths of way back, of the same path: as near to that as waypoints allow.
TEST(HeadBefore, IsTheFirstWaypointOfTheSoftBead) {
  plan::ToolPlan plan;
  std::mt19937 random(54);
  std::uniform_real_distribution<double> u(0.05, 1.5);
  for (int path = 0; path < 3; ++path) {
    std::vector<Vector3d> points;
    double x = 0.0;
    for (int i = 0; i < 40; ++i)
      points.emplace_back(x += u(random), 3.0 * path, 1.0);
    test::appendPath(plan, points, std::vector<Vector3d>(40, Vector3d::UnitZ()), path);
  }
  const std::vector<std::size_t> before = motion::headBefore(plan);
  ASSERT_EQ(before.size(), 120u);
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      std::size_t wanted = path.first;
      while (wanted < i && plan.position[i].x() - plan.position[wanted + 1].x() >=
                               2.0 * static_cast<double>(1.2f))
        ++wanted;
      EXPECT_EQ(before[i], wanted) << i;
    }
}

// A ring whose third layer is below the plate, and whose fourth leans into printed beads.
TEST(HeadRefusals, NameTheWaypointsWhereTheHeadCollides) {
  plan::ToolPlan plan = test::cylinder(10.0, 6);
  const std::size_t below = plan.paths[2].first + 10, into = plan.paths[5].first + 30;
  plan.position[below].z() = -5.0;
  plan.direction[into] =
      Vector3d(-plan.position[into].y(), plan.position[into].x(), -4.0).normalized();
  Scene s(plan);
  const std::vector<std::size_t> before = motion::headBefore(s.plan);
  const auto refusals = motion::headRefusals(s.scene, before, {});
  ASSERT_EQ(refusals.size(), s.plan.waypointCount());
  for (std::size_t w = 0; w < refusals.size(); ++w)
    if (w != below && w != into) {
      EXPECT_EQ(refusals[w], motion::Refusal::None) << w;
    }
  EXPECT_NE(refusals[below], motion::Refusal::None);
  EXPECT_NE(refusals[into], motion::Refusal::None);
}

// Beads that a path deposited more than two widths ago are hard: a nozzle that returns to them too
// low would plough through.
TEST(HeadRefusals, TwoWidthsAreSoftAndNoMore) {
  for (const double x : {8.2, 9.2}) { // 2.8 and 1.8 mm of way from the bead there
    plan::ToolPlan plan;
    std::vector<Vector3d> points;
    for (int i = 0; i <= 10; ++i)
      points.emplace_back(i, 0.0, 0.8);
    points.emplace_back(x, 0.0, 0.2);
    test::appendPath(plan, points, std::vector<Vector3d>(12, Vector3d::UnitZ()), 0);
    Scene s(plan);
    const auto refusals = motion::headRefusals(s.scene, motion::headBefore(s.plan), {});
    EXPECT_EQ(refusals[11] == motion::Refusal::HeadPart, x < 9.0) << x;
    EXPECT_EQ(refusals[10], motion::Refusal::None);
  }
}

// A rod is printed on within its length and room, and no further.
TEST(HeadRefusals, NothingIsPrintedBeyondTheRod) {
  const robot::Cell cell = cellOf("lathe");
  const double radius = cell.rod()->printableRadiusMm, half = 0.5 * cell.rod()->lengthMm;
  plan::ToolPlan plan;
  const std::vector<Vector3d> tips{{0, 0, radius - 0.01},
                                   {0, 0, radius + 0.01},
                                   {half - 0.01, 0, 5},
                                   {half + 0.01, 0, 5},
                                   {-half - 0.01, 0, 5},
                                   {0, 0.8 * radius, 0.6 * radius},
                                   {0, 0.9 * radius, 0.6 * radius}};
  test::appendPath(plan, tips, std::vector<Vector3d>(7, Vector3d::UnitZ()), 0);
  Scene s(plan, "lathe");
  const auto refusals = motion::headRefusals(s.scene, motion::headBefore(s.plan), {});
  const bool beyond[] = {false, true, false, true, true, false, true};
  for (std::size_t w = 0; w < 7; ++w)
    EXPECT_EQ(refusals[w] == motion::Refusal::BeyondRod, beyond[w]) << w;
}

TEST(Levers, OfARodAreThePlansRadius) {
  plan::ToolPlan plan;
  test::appendPath(plan, {{90, 3, 4}, {0, 0, 2}}, {Vector3d::UnitZ(), Vector3d::UnitZ()}, 0);
  const std::vector<double> levers = motion::leversOf(plan, cellOf("lathe"));
  ASSERT_EQ(levers.size(), 1u);
  EXPECT_NEAR(levers[0], 5.0, 1e-12);
  EXPECT_TRUE(motion::leversOf(plan, cellOf("ur5-fixed")).empty());
}

// No point of the bodies they carry moves further by a radian than its lever.
TEST(Levers, OfTurnsHoldAllThatTheyCarry) {
  const robot::Cell cell = cellOf("irb1200-irbp");
  plan::ToolPlan plan;
  test::appendPath(plan, {{300, 0, 200}, {0, -350, 10}}, {Vector3d::UnitZ(), Vector3d::UnitZ()}, 0);
  const std::vector<double> levers = motion::leversOf(plan, cell);
  ASSERT_EQ(levers.size(), 2u);
  std::mt19937 random(55);
  for (int round = 0; round < 60; ++round) {
    const JointVector q = anyAxes(cell, random), axes = motion::axesOf(cell, q);
    for (const Vector3d& p : plan.position) {
      const motion::AxisTwists twists = motion::axisTwists(cell, axes, cell.base_T_work(q) * p);
      for (Eigen::Index k = 0; k < 2; ++k)
        EXPECT_LE(twists.col(k).head<3>().norm(), levers[static_cast<std::size_t>(k)] + 1e-9);
    }
  }
}

TEST(Surrounds, HoldAllThatIsPrintedBefore) {
  plan::ToolPlan plan;
  const std::vector<Vector3d> up(2, Vector3d::UnitZ());
  test::appendPath(plan, {{2, -4, 1}, {6, 8, 1}}, up, 0);
  test::appendPath(plan, {{-10, 0, 5}, {3, 3, 7}}, up, 1);
  const std::vector<motion::PrintedBounds> balls = motion::printedBoundsOf(plan);
  ASSERT_EQ(balls.size(), 3u);
  EXPECT_EQ(balls[0].radius, 0.0);
  EXPECT_LT((balls[1].centre - Vector3d(3, 2, 0.5)).norm(), 1e-12);
  EXPECT_NEAR(balls[1].radius, 0.5 * Vector3d(6, 12, 1).norm(), 1e-12);
  EXPECT_LT((balls[2].centre - Vector3d(-2, 2, 3.5)).norm(), 1e-12);
  EXPECT_NEAR(balls[2].radius, 0.5 * Vector3d(16, 12, 7).norm(), 1e-12);
  for (std::size_t k = 1; k < 3; ++k)
    for (std::size_t w = 0; w < 2 * k; ++w)
      EXPECT_LE((plan.position[w] - balls[k].centre).norm(), balls[k].radius + 1e-12);
}

// Nothing up to four fifths of a joint's range, from there with the square, equal on both sides.
TEST(JointCosts, RiseTowardsLimits) {
  const std::vector<robot::JointLimits> limits{{-2, 4, 1, 1}, {-1, 1, 1, 1}};
  const auto cost = [&](double a, double b) {
    JointVector q(3);
    q << a, b, 99.0; // an axis without a limit here
    return motion::limitCost(q, limits);
  };
  for (const double share : {0.0, 0.5, 0.79, -0.79})
    EXPECT_EQ(cost(1 + 3 * share, share), 0.0);
  const double maximum = cost(4, 0);
  EXPECT_GT(maximum, 0.0);
  for (const double into : {0.1, 0.5, 0.9, 1.0}) {
    const double share = 0.8 + 0.2 * into;
    for (const double sign : {-1.0, 1.0}) {
      EXPECT_NEAR(cost(1 + sign * 3 * share, 0), maximum * into * into, 1e-12);
      EXPECT_NEAR(cost(1, sign * share), maximum * into * into, 1e-12);
      EXPECT_NEAR(cost(1 + sign * 3 * share, -share), 2 * maximum * into * into, 1e-12);
    }
  }
}

TEST(JointCosts, TurningBackIsCheaperThanAnotherBranch) {
  const std::vector<robot::JointLimits> limits(2, {-10, 10, 1, 1});
  const auto cost = [&](double a, double b) {
    return motion::startCost(JointVector::Zero(2), Eigen::Vector2d(a, b), limits);
  };
  EXPECT_EQ(cost(0, 0), 0.0);
  EXPECT_NEAR(cost(0.3, -0.4), 0.7, 1e-12) << "what is near costs its way";
  const double rotation = cost(base::kTwoPi, 0);
  EXPECT_GT(rotation, 0.0);
  EXPECT_LT(rotation, 1.0);
  EXPECT_NEAR(cost(-base::kTwoPi, 0), rotation, 1e-12);
  EXPECT_NEAR(cost(base::kTwoPi + 0.2, -0.1), rotation + 0.3, 1e-12);
  EXPECT_NEAR(cost(0, 2 * base::kTwoPi), 2 * rotation, 1e-12);
  // Beyond a radian it is another branch, the dearer the further.
  EXPECT_NEAR(cost(1.0, 0.9), 1.9, 1e-12);
  const double beyond = cost(1.5, 0) - 1.5;
  EXPECT_GT(beyond, 0.5);
  EXPECT_NEAR(cost(0, -2.0) - 2.0, 2 * beyond, 1e-12);
  EXPECT_NEAR(cost(2.0, 1.9) - 3.9, 2 * beyond, 1e-12) << "of the joint that goes furthest";
}

namespace {
constexpr double kFinelyMm = 0.02;

// The least clearance on the motion to a point, or `minimum` where that is less: at most kFinelyMm
// above the true one. From place to place on the way as far as nothing can have come nearer.
double finelyOnTheWayTo(std::size_t point, const plan::Trajectory& t, const Scene& s,
                        std::size_t before, double minimum) {
  constexpr double kFarthestMm = 1500.0; // of a point from a joint's axis
  constexpr double kBent = 1.5, kNearRad = 0.3, kAllMm = 100.0;
  const JointVector from = Eigen::Map<const Eigen::VectorXd>(t.at(point - 1), t.dof);
  const JointVector to = Eigen::Map<const Eigen::VectorXd>(t.at(point), t.dof);
  const bool straight =
      t.move[point] == plan::MoveKind::Linear || t.move[point] == plan::MoveKind::Wipe;
  const Isometry3d start = s.cell.work_T_tool(from), end = s.cell.work_T_tool(to);
  const double displacementMm = kBent * kFarthestMm * (to - from).cwiseAbs().sum();
  JointVector q = from, solved;
  std::vector<JointVector> scratch;
  collision::CellCollision::Frames frames;
  for (double share = 0.0; share < 1.0;) {
    if (straight) {
      const Vector3d tip = start.translation() + share * (end.translation() - start.translation());
      const Quaterniond rotation =
          Quaterniond(start.linear()).slerp(share, Quaterniond(end.linear()));
      EXPECT_TRUE(motion::solveNear(s.cell, tip, rotation, q, kNearRad, scratch, solved));
      q = solved;
    } else {
      q = from + share * (to - from);
    }
    s.cell.framePoses(q, frames);
    const double clear =
        s.collision.clearanceToPart(frames, s.part, before, s.collision.clearance(frames, kAllMm));
    minimum = std::min(minimum, clear);
    share += (clear - minimum + kFinelyMm) / std::max(displacementMm, kFinelyMm);
  }
  return minimum;
}
} // namespace

// A finished motion is clear; with a point moved into printed beads it collides, there.
TEST(LastLook, FindsCollisionsAndTheLeastClearance) {
  Scene s(test::cylinder(10.0, 4));
  plan::Trajectory t =
      motion::MotionPlanner(s.plan, s.cell, process::Tooling(s.process), s.part, s.options)
          .plan({})
          .trajectory;
  const std::vector<std::size_t> before = motion::headBefore(s.plan);
  const motion::TrajectoryCheck sound = motion::checkTrajectory(t, s.scene, before, 100.0, {});
  EXPECT_TRUE(sound.collisions.empty());
  // The least clearance, point by point and then between them.
  double minimum = 100.0;
  std::size_t at = 0, next = s.plan.waypointCount();
  std::vector<std::size_t> nexts(t.pointCount());
  collision::CellCollision::Frames frames;
  for (std::size_t i = t.pointCount(); i-- > 0;) {
    next = t.waypoint[i] != plan::kNoWaypoint ? t.waypoint[i] : next;
    nexts[i] = next;
    s.cell.framePoses(Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof), frames);
    const double clear =
        s.collision.clearanceToPart(frames, s.part, next, s.collision.clearance(frames, 100.0));
    if (clear <= minimum) {
      minimum = clear;
      at = i;
    }
  }
  EXPECT_LT(minimum, 100.0);
  double finely = minimum;
  for (std::size_t i = 1; i < t.pointCount(); ++i)
    finely = finelyOnTheWayTo(i, t, s, nexts[i], finely);
  EXPECT_LE(sound.minClearanceMm, finely + 1e-6);
  EXPECT_GE(sound.minClearanceMm, finely - collision::kMotionExactMm - kFinelyMm);
  EXPECT_LE(sound.closestPoint, at + 1);
  ASSERT_GE(sound.closestPoint + 1, std::max<std::size_t>(at, 2));
  EXPECT_LE(finelyOnTheWayTo(sound.closestPoint, t, s, nexts[sound.closestPoint], 100.0),
            sound.minClearanceMm + collision::kMotionExactMm + kFinelyMm);
  EXPECT_NEAR(motion::checkTrajectory(t, s.scene, before, 0.5 * minimum, {}).minClearanceMm,
              0.5 * minimum, 1e-12);

  // A travel through the ring instead of over it.
  std::size_t last = t.pointCount() - 1;
  while (t.waypoint[last] == plan::kNoWaypoint)
    --last;
  const JointVector end = Eigen::Map<const Eigen::VectorXd>(t.at(last), t.dof);
  std::vector<JointVector> scratch;
  JointVector down;
  const Isometry3d pose = s.cell.work_T_tool(end);
  ASSERT_TRUE(motion::solveNear(s.cell, pose.translation() - Vector3d(0, 0, 2.0),
                                Quaterniond(pose.linear()), end, 1.0, scratch, down));
  std::copy(down.data(), down.data() + 6,
            t.joints.begin() + static_cast<std::ptrdiff_t>(6 * (last + 1)));
  t.move[last + 1] = plan::MoveKind::Linear;
  const motion::TrajectoryCheck meets = motion::checkTrajectory(t, s.scene, before, 100.0, {});
  ASSERT_FALSE(meets.collisions.empty());
  EXPECT_EQ(meets.collisions.front().point, last + 1);
  for (std::size_t k = 1; k < meets.collisions.size(); ++k)
    EXPECT_GT(meets.collisions[k].point, meets.collisions[k - 1].point);
}
