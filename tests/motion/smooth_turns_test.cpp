#include "motion/motion_options.h"
#include "motion/smoothing/smooth_turns.h"

#include "base/run_context.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "motion/ladder/divided_step.h"
#include "motion/motion_scene.h"
#include "motion/nozzle_frame.h"
#include "motion/sample_plans.h"
#include "motion/sequence.h"
#include "motion/smooth_points.h"
#include "motion/smoothing/smooth_run.h"
#include "motion/timed_points.h"

#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using motion::RotationHold;
using motion::RunPoint;
using motion::TurnedPoint;
using robot::JointVector;
using test::evenTimes;
using test::largestOff;
using test::onThreads;

namespace {

// A closed wall, leaning, in the arm's joints: its turn about the nozzle wanders by chance.
struct Wall {
  process::Process process = process::loadProcess("fdm-1.0");
  robot::Cell cell;
  robot::ArmTwists twists;
  plan::ToolPlan plan;
  std::vector<RunPoint> points;
  std::vector<double> times;

  explicit Wall(int seed, double wander = 0.02)
      : cell(robot::loadCell("ur5-fixed", process, test::disc(20.0))),
        twists(*cell.robot().kinematics),
        plan(test::rings(
            1, [](int) { return 15.0; }, [](int) { return 0.8; }, [](int) { return 0.3; })) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> step(-wander, wander);
    Eigen::Quaterniond tool = motion::uprightTool();
    double rotation = 20.0 * step(random);
    JointVector q = cell.home();
    std::vector<JointVector> scratch;
    for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
      tool = motion::carried(tool, plan.direction[i]);
      rotation += step(random);
      const Eigen::Quaterniond at = motion::turned(tool, rotation);
      if (!motion::solveNear(cell, plan.position[i], at, q, i == 0 ? base::kTwoPi : 0.5, scratch,
                             q))
        break;
      points.push_back({{plan.position[i], at, q, {}}, i, i, 0.0, 20.0});
      times.push_back(times.empty() ? 0.0 : times.back() + 0.04 + 0.5 * std::abs(step(random)));
    }
  }
};

} // namespace

// Of this arm the turn about the nozzle is joint 4 alone, so that the least jerk of a stretch with
// equal ends keeps joint 4 at rest, whatever the other joints do.
TEST(RotationSmoother, WristOfAScaraRests) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("t3", process, test::disc(20.0));
  const robot::ArmTwists twists(*cell.robot().kinematics);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> chance(-0.02, 0.02);
  std::vector<RunPoint> points;
  constexpr std::size_t kPoints = 120;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double t = static_cast<double>(i) / (kPoints - 1);
    JointVector q(4);
    q << 0.2 + 0.3 * t * t, 1.2 - 0.2 * std::sin(3.0 * t), cell.home()[2], 0.4;
    if (i > 0 && i + 1 < kPoints)
      q[3] += 0.2 * std::sin(base::kPi * t) + chance(random);
    RunPoint p;
    p.at = motion::stateAt(cell, q);
    points.push_back(p);
  }
  const motion::RotationSmoother smoother(cell, twists, points, evenTimes(kPoints, 0.05));
  std::vector<TurnedPoint> at = smoother.start(onThreads(1));
  std::vector<RotationHold> holds(kPoints);
  holds.front().stay = holds.back().stay = motion::kHeld;
  smoother.smooth(at, holds, {60, 0.0, 0.3}, onThreads(1));
  for (std::size_t i = 0; i < kPoints; ++i) {
    EXPECT_NEAR(at[i].q[3], 0.4, 1e-4) << i;
    EXPECT_LT((at[i].q - points[i].at.q).head(3).norm(), 1e-6);
    EXPECT_LT(largestOff(cell, points[i], at[i]), 1e-6);
  }
}

TEST(RotationSmoother, RateIsTheDerivativeOfTheInverse) {
  const Wall wall(1);
  ASSERT_EQ(wall.points.size(), wall.plan.waypointCount());
  const motion::RotationSmoother smoother(wall.cell, wall.twists, wall.points, wall.times);
  const auto at = smoother.start(onThreads(1));
  constexpr double kStep = 1e-5;
  std::vector<JointVector> scratch;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto& state = wall.points[i].at;
    JointVector more, less;
    ASSERT_TRUE(motion::solveNear(wall.cell, state.tip, motion::turned(state.tool, kStep), state.q,
                                  0.1, scratch, more));
    ASSERT_TRUE(motion::solveNear(wall.cell, state.tip, motion::turned(state.tool, -kStep), state.q,
                                  0.1, scratch, less));
    EXPECT_LT(((more - less) / (2.0 * kStep) - at[i].rate).norm(), 1e-5 * (1.0 + at[i].rate.norm()))
        << i;
  }
}

TEST(RotationSmoother, NeverWorseAndEveryPointStaysWhereItIs) {
  for (int seed = 1; seed <= 12; ++seed) {
    const Wall wall(seed);
    ASSERT_EQ(wall.points.size(), wall.plan.waypointCount()) << seed;
    const motion::RotationSmoother smoother(wall.cell, wall.twists, wall.points, wall.times);
    const auto start = smoother.start(onThreads(2));
    std::vector<RotationHold> holds(wall.points.size());
    holds[7].stay = motion::kHeld;
    auto at = start;
    smoother.smooth(at, holds, {}, onThreads(2));
    EXPECT_LT(smoother.cost(at, holds), 0.4 * smoother.cost(start, holds)) << seed;
    EXPECT_EQ(at[7].q, start[7].q);
    for (std::size_t i = 0; i < at.size(); ++i) {
      EXPECT_LT(largestOff(wall.cell, wall.points[i], at[i]), 1e-6) << seed;
      for (Eigen::Index j = 0; j < at[i].q.size(); ++j) {
        const auto& limit = wall.cell.limits()[static_cast<std::size_t>(j)];
        EXPECT_GE(at[i].q[j], limit.min);
        EXPECT_LE(at[i].q[j], limit.max);
      }
    }
    auto alone = start;
    smoother.smooth(alone, holds, {}, onThreads(1));
    for (std::size_t i = 0; i < at.size(); ++i)
      ASSERT_EQ(at[i].q, alone[i].q) << "threads";
  }
}

// A firm hold on turns brings them back to the points' own; one on their differences makes them
// equal.
TEST(RotationSmoother, HoldsBringTurnsBack) {
  const Wall wall(3);
  const motion::RotationSmoother smoother(wall.cell, wall.twists, wall.points, wall.times);
  const auto start = smoother.start(onThreads(1));
  std::vector<RotationHold> free(wall.points.size()), firm(wall.points.size(), {1e6, 0.0}),
      together(wall.points.size(), {0.0, 1e6});
  auto at = start;
  smoother.smooth(at, free, {}, onThreads(1));
  const motion::RotationSmoothing much{60, 1e-9, 0.3};
  auto back = at, joined = at;
  smoother.smooth(back, firm, much, onThreads(1));
  smoother.smooth(joined, together, much, onThreads(1));
  double away = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    away = std::max(away, std::abs(at[i].rotation));
    EXPECT_LT(std::abs(back[i].rotation), 1e-3) << i;
    if (i > 0) {
      EXPECT_LT(std::abs(joined[i].rotation - joined[i - 1].rotation), 1e-3) << i;
    }
  }
  EXPECT_GT(away, 0.05);
}

// Joints of points near which the rates are taken: the tool leans and turns a little, the tip
// stays.
TEST(RotationSmoother, RatesOfLeansAreTheDerivativesOfTheInverse) {
  const Wall wall(2);
  ASSERT_EQ(wall.points.size(), wall.plan.waypointCount());
  const motion::RotationSmoother smoother(wall.cell, wall.twists, wall.points, wall.times, 0.06);
  const auto start = smoother.start(onThreads(1));
  auto at = start;
  smoother.smooth(at, std::vector<RotationHold>(at.size()), {}, onThreads(1));
  constexpr double kStep = 1e-5;
  std::vector<JointVector> scratch;
  double longest = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    longest = std::max(longest, at[i].lean.norm());
    ASSERT_EQ(at[i].rate.cols(), 3);
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto& state = wall.points[i].at;
      const auto moved = [&](double by, JointVector& q) {
        TurnedPoint p = at[i];
        if (k == 0)
          p.rotation += by;
        else
          p.lean[k - 1] += by;
        return motion::solveNear(wall.cell, state.tip, p.tool(state.tool), at[i].q, 0.1, scratch,
                                 q);
      };
      JointVector more, less;
      ASSERT_TRUE(moved(kStep, more) && moved(-kStep, less));
      EXPECT_LT(((more - less) / (2.0 * kStep) - at[i].rate.col(k)).norm(),
                1e-5 * (1.0 + at[i].rate.col(k).norm()))
          << i << " " << k;
    }
  }
  EXPECT_GT(longest, 0.01); // it leans indeed
}

namespace {

// The nozzle on the spot, its direction with one kink of `rad` in the middle, both ends equal.
std::vector<RunPoint> kinked(const robot::Cell& cell, std::size_t count, double rad) {
  std::vector<RunPoint> points;
  const motion::RobotState home = motion::stateAt(cell, cell.home());
  std::vector<JointVector> scratch;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    RunPoint p;
    p.at = home;
    p.at.tool = motion::leant(home.tool,
                              rad * (1.0 - std::abs(2.0 * t - 1.0)) * Eigen::Vector2d(0.6, -0.8));
    if (!motion::solveNear(cell, home.tip, p.at.tool, home.q, 0.5, scratch, p.at.q))
      return {};
    points.push_back(p);
  }
  return points;
}

} // namespace

// Standing still is without jerk: where the cone has room, directions with a kink come to that.
TEST(RotationSmoother, KinkWithinTheConeIsRemoved) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::disc(20.0));
  const robot::ArmTwists twists(*cell.robot().kinematics);
  constexpr std::size_t kPoints = 41;
  constexpr double kKink = 0.02;
  const std::vector<RunPoint> points = kinked(cell, kPoints, kKink);
  ASSERT_EQ(points.size(), kPoints);
  std::vector<RotationHold> holds(kPoints);
  holds.front() = holds.back() = {motion::kHeld, 0.0, motion::kHeld};
  const auto smoothed = [&](double coneRad) {
    const motion::RotationSmoother smoother(cell, twists, points, evenTimes(kPoints, 0.05),
                                            coneRad);
    auto at = smoother.start(onThreads(1));
    smoother.smooth(at, holds, {200, 0.0, 0.3}, onThreads(1));
    return at;
  };
  const auto wide = smoothed(2.0 * kKink);
  for (std::size_t i = 0; i < kPoints; ++i)
    EXPECT_LT((wide[i].q - cell.home()).norm(), 1e-4) << i;
  const auto narrow = smoothed(0.5 * kKink); // uses the whole cone
  const auto angle = [&](std::size_t i) {
    return motion::angleBetween(narrow[i].tool(points[i].at.tool), points[0].at.tool);
  };
  for (const TurnedPoint& p : narrow)
    EXPECT_LT(p.lean.norm(), 0.5 * kKink);
  EXPECT_GT(narrow[kPoints / 2].lean.norm(), 0.45 * kKink);
  EXPECT_LT(angle(kPoints / 2), 0.6 * kKink);
}

// Motion that is already as smooth as possible stays.
TEST(RotationSmoother, OneDirectionOnTheSpotIsKept) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::disc(20.0));
  const robot::ArmTwists twists(*cell.robot().kinematics);
  const std::vector<RunPoint> points = kinked(cell, 30, 0.0);
  ASSERT_EQ(points.size(), 30u);
  const motion::RotationSmoother smoother(cell, twists, points, evenTimes(30, 0.05), 0.05);
  auto at = smoother.start(onThreads(1));
  std::vector<RotationHold> holds(points.size());
  holds.front() = holds.back() = {motion::kHeld, 0.0, motion::kHeld};
  smoother.smooth(at, holds, {}, onThreads(1));
  for (const TurnedPoint& p : at) {
    EXPECT_LT(p.lean.norm(), 1e-8);
    EXPECT_LT((p.q - cell.home()).norm(), 1e-8);
  }
}

TEST(RotationSmoother, LeansStayInTheirConeAndTipsWhereTheyAre) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> chance(-0.03, 0.03);
  for (int seed = 1; seed <= 10; ++seed) {
    Wall wall(seed);
    ASSERT_EQ(wall.points.size(), wall.plan.waypointCount()) << seed;
    std::vector<JointVector> scratch;
    for (RunPoint& p : wall.points) { // directions by chance, some beyond the cone
      p.at.tool = motion::leant(p.at.tool, {chance(random), chance(random)});
      ASSERT_TRUE(motion::solveNear(wall.cell, p.at.tip, p.at.tool, p.at.q, 0.5, scratch, p.at.q));
    }
    const double cone = seed % 2 == 0 ? 0.01 : 0.05;
    const motion::RotationSmoother smoother(wall.cell, wall.twists, wall.points, wall.times, cone);
    const motion::RotationSmoother turnsOnly(wall.cell, wall.twists, wall.points, wall.times);
    std::vector<RotationHold> holds(wall.points.size());
    holds[5].stay = holds[5].upright = motion::kHeld;
    holds[9].upright = motion::kHeld;
    const auto start = smoother.start(onThreads(2));
    auto at = start, turns = turnsOnly.start(onThreads(2));
    smoother.smooth(at, holds, {}, onThreads(2));
    turnsOnly.smooth(turns, holds, {}, onThreads(2));
    EXPECT_LT(smoother.cost(at, holds), turnsOnly.cost(turns, holds)) << seed;
    EXPECT_EQ(at[5].q, start[5].q);
    EXPECT_TRUE(at[9].lean.isZero(0.0));
    for (std::size_t i = 0; i < at.size(); ++i) {
      const RunPoint& p = wall.points[i];
      const Eigen::Isometry3d pose = wall.cell.work_T_tool(at[i].q);
      EXPECT_LT((pose.translation() - p.at.tip).norm(), 1e-6);
      const double leans = std::atan2((-pose.linear().col(2)).cross(p.at.direction()).norm(),
                                      -pose.linear().col(2).dot(p.at.direction()));
      EXPECT_LE(leans, cone + 1e-9) << seed;
      EXPECT_NEAR(leans, at[i].lean.norm(), 1e-8);
      for (Eigen::Index j = 0; j < at[i].q.size(); ++j) {
        const auto& limit = wall.cell.limits()[static_cast<std::size_t>(j)];
        EXPECT_GE(at[i].q[j], limit.min);
        EXPECT_LE(at[i].q[j], limit.max);
      }
    }
    auto alone = start;
    smoother.smooth(alone, holds, {}, onThreads(1));
    for (std::size_t i = 0; i < at.size(); ++i)
      ASSERT_EQ(at[i].q, alone[i].q) << "threads";
  }
}

TEST(LeanCone, ItsNumbersAndDerivativesAgree) {
  const motion::LeanCone cone{0.07};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> chance(-3.0, 3.0);
  for (int n = 0; n < 50; ++n) {
    const Eigen::Vector2d free(chance(random), chance(random)), lean = cone.at(free);
    EXPECT_LT(lean.norm(), cone.rad);
    EXPECT_LT((cone.freeOf(lean) - free).norm(), 1e-9 * (1.0 + free.norm()));
    constexpr double kStep = 1e-6;
    const Eigen::Quaterniond own = Eigen::Quaterniond(0.3, -0.2, 0.9, 0.1).normalized();
    for (Eigen::Index k = 0; k < 2; ++k) {
      const Eigen::Vector2d by = kStep * Eigen::Vector2d::Unit(k);
      EXPECT_LT(
          ((cone.at(free + by) - cone.at(free - by)) / (2.0 * kStep) - cone.slope(free).col(k))
              .norm(),
          1e-8);
      const Eigen::Quaterniond rotation =
          motion::leant(own, lean - by).conjugate() * motion::leant(own, lean + by);
      EXPECT_LT((rotation.vec() / kStep - motion::leanRates(lean).col(k)).norm(), 1e-8);
    }
    EXPECT_NEAR(motion::angleBetween(own, motion::leant(own, lean)), lean.norm(), 1e-12);
  }
}

namespace {

struct SmoothScene {
  Wall wall;
  collision::CellCollision collision;
  collision::GrowingPart part;
  motion::MotionOptions options;
  motion::MotionScene scene;
  motion::TimingLimits limits;

  explicit SmoothScene(int seed)
      : wall(seed, 0.005), collision(wall.cell, wall.process),
        part(wall.plan, 0.45, {}), scene{wall.plan, wall.cell, collision, part, options, {}},
        limits(motion::timingLimits(wall.cell, wall.process)) {}

  motion::SmoothedRun smoothed(const motion::Meets& meets, bool endsLift = true) const {
    return motion::smoothRun(
        {scene, wall.twists, limits}, wall.points, meets,
        [endsLift](const motion::RobotState&, bool) { return endsLift; }, onThreads(2));
  }
};

} // namespace

TEST(SmoothRun, RestoresTheOriginalAtCollisions) {
  for (int seed = 1; seed <= 4; ++seed) {
    const SmoothScene s(seed);
    const auto& points = s.wall.points;
    const auto clear = s.smoothed([](const JointVector&, std::size_t) { return false; });
    ASSERT_EQ(clear.points.size(), points.size());
    // Where joints moved furthest from the original, half of that distance is too much.
    std::size_t furthest = 0;
    double maximum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (const double off = (clear.points[i].at.q - points[i].at.q).norm(); off > maximum) {
        maximum = off;
        furthest = i;
      }
    ASSERT_GT(maximum, 1e-3) << seed;
    const motion::Meets meets = [&](const JointVector& q, std::size_t w) {
      return w == furthest && (q - points[w].at.q).norm() > 0.5 * maximum;
    };
    // Ends whose lift is not clear stay as the ladder gave them.
    const auto kept = s.smoothed(meets, false);
    const double off = (kept.points[furthest].at.q - points[furthest].at.q).norm();
    EXPECT_LE(off, 0.5 * maximum);
    // And does not simply equal the original.
    double moved = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
      moved = std::max(moved, (kept.points[i].at.q - points[i].at.q).norm());
    EXPECT_GT(moved, 1e-4) << seed;
    EXPECT_EQ(kept.points.front().at.q, points.front().at.q);
    EXPECT_EQ(kept.points.back().at.q, points.back().at.q);
  }
}

// A kick at an end is removed; the nozzle stays near the start of the next path.
TEST(SmoothRun, EndsTurnALittleWhereTheyCanBeLifted) {
  constexpr double kLittle = 0.2; // rad
  const motion::Meets nothing = [](const JointVector&, std::size_t) { return false; };
  for (int seed = 1; seed <= 4; ++seed) {
    const SmoothScene s(seed);
    const auto held = s.smoothed(nothing, false).points, free = s.smoothed(nothing, true).points;
    const auto jerk = [](const std::vector<RunPoint>& points) {
      return motion::jerkOf(motion::jointsOf(points), evenTimes(points.size(), 0.04)).sumSquared;
    };
    EXPECT_LT(jerk(free), jerk(held)) << seed;
    for (const std::size_t end : {std::size_t{0}, free.size() - 1}) {
      const double rotation = motion::angleBetween(free[end].at.tool, s.wall.points[end].at.tool);
      EXPECT_GT(rotation, 1e-6) << seed;
      EXPECT_LT(rotation, kLittle) << seed;
    }
  }
}

TEST(SmoothRun, StaysAsItWasWhereNothingElseIsClear) {
  const SmoothScene s(2);
  const auto& points = s.wall.points;
  const auto run = s.smoothed(
      [&](const JointVector& q, std::size_t w) { return (q - points[w].at.q).norm() > 1e-12; });
  for (std::size_t i = 0; i < run.points.size(); ++i)
    EXPECT_EQ(run.points[i].at.q, points[i].at.q);
}

// Directions by chance: leaning takes their jerk away, within its cone and nowhere else.
TEST(SmoothRun, LeansWithinTheConeAndNoFurther) {
  std::mt19937 random(77);
  std::uniform_real_distribution<double> chance(-0.02, 0.02);
  for (int seed = 1; seed <= 4; ++seed) {
    SmoothScene s(seed);
    s.options.leanRad = 0.04;
    std::vector<JointVector> scratch;
    for (RunPoint& p : s.wall.points) {
      p.at.tool = motion::leant(p.at.tool, {chance(random), chance(random)});
      ASSERT_TRUE(
          motion::solveNear(s.wall.cell, p.at.tip, p.at.tool, p.at.q, 0.5, scratch, p.at.q));
    }
    const auto run = s.smoothed([](const JointVector&, std::size_t) { return false; });
    ASSERT_EQ(run.points.size(), run.before.size());
    double maximum = 0.0, volume = 0.0, volumeBefore = 0.0;
    std::size_t waypoints = 0;
    for (std::size_t i = 0; i < run.points.size(); ++i) {
      const RunPoint &p = run.points[i], &before = run.before[i];
      const Eigen::Isometry3d pose = s.wall.cell.work_T_tool(p.at.q);
      EXPECT_LT((pose.translation() - before.at.tip).norm(), 1e-6);
      EXPECT_LT((-pose.linear().col(2) - p.at.direction()).norm(), 1e-6);
      maximum =
          std::max(maximum, motion::angleBetween(motion::carried(before.at.tool, p.at.direction()),
                                                 before.at.tool));
      volume += p.volumeMm3;
      waypoints += p.waypoint != plan::kNoWaypoint;
    }
    for (const RunPoint& p : s.wall.points)
      volumeBefore += p.volumeMm3;
    EXPECT_LE(maximum, s.options.leanRad + 1e-9);
    EXPECT_GT(maximum, 0.005);
    EXPECT_EQ(waypoints, s.wall.points.size());
    EXPECT_NEAR(volume, volumeBefore, 1e-9);
    const auto jerk = [&](const std::vector<RunPoint>& points) {
      return motion::jerkOf(motion::jointsOf(points), evenTimes(points.size(), 0.04)).sumSquared;
    };
    EXPECT_LT(jerk(run.points), jerk(run.before)) << seed;
  }
}

// A step that is divided: evenly, with its volume shared, where its ends were.
TEST(DividedStep, SharesWayTurnAndVolume) {
  const SmoothScene s(1);
  const RunPoint& from = s.wall.points[3];
  RunPoint to = s.wall.points[4];
  to.volumeMm3 = 0.6;
  std::vector<RunPoint> points{from};
  ASSERT_TRUE(motion::appendDivided(s.scene, to, 4, points));
  ASSERT_EQ(points.size(), 5u);
  const double angle = motion::angleBetween(from.at.tool, to.at.tool);
  for (std::size_t k = 1; k < points.size(); ++k) {
    const RunPoint &a = points[k - 1], &b = points[k];
    EXPECT_NEAR((b.at.tip - a.at.tip).norm(), 0.25 * (to.at.tip - from.at.tip).norm(), 1e-9);
    EXPECT_NEAR(motion::angleBetween(a.at.tool, b.at.tool), 0.25 * angle, 1e-9);
    EXPECT_DOUBLE_EQ(b.volumeMm3, 0.15);
    EXPECT_EQ(b.waypoint, k == 4 ? to.waypoint : plan::kNoWaypoint);
    EXPECT_EQ(b.next, to.next);
    EXPECT_LT((s.wall.cell.work_T_tool(b.at.q).translation() - b.at.tip).norm(), 1e-6);
  }
  EXPECT_LT((points.back().at.q - to.at.q).norm(), 1e-6);
}
