#include "motion/timing.h"

#include "base/units.h"
#include "motion/jerk.h"
#include "motion/smoothing/even_turns.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using motion::TimedPoint;

namespace {

motion::TimingLimits limitsOf(int dof) {
  motion::TimingLimits limits;
  limits.joints.assign(static_cast<std::size_t>(dof), {-6, 6, 3.0, 14.0});
  limits.accelerationMmPerS2 = 500;
  return limits;
}

} // namespace

// A line of 100 mm at 20 mm/s with 500 mm/s2: two ramps of 0.04 s over 0.4 mm each.
TEST(Timing, TrapezoidInClosedForm) {
  std::vector<TimedPoint> points;
  for (int i = 0; i <= 100; ++i) {
    TimedPoint p;
    p.q = robot::JointVector::Zero(2);
    p.tip = {static_cast<double>(i), 0, 0};
    p.speedMmPerS = 20;
    points.push_back(p);
  }
  const auto times = motion::timesOf(points, limitsOf(2));
  EXPECT_NEAR(times.back(), 2 * 0.04 + (100 - 0.8) / 20, 1e-9);
  const auto single = motion::timesOf({points.front(), points.back()}, limitsOf(2));
  EXPECT_NEAR(single.back(), times.back(), 1e-9);
}

// A joint move from rest to rest, v 0.5 x 0.9 x 3 rad/s: of 2 rad at 1.4 rad/s2.
TEST(Timing, ALoadedArmTravelsGently) {
  TimedPoint from, to;
  from.q = to.q = robot::JointVector::Zero(2);
  to.q[1] = 2.0;
  to.jointMove = true;
  motion::TimingLimits limits = limitsOf(2);
  const double before = motion::timesOf({from, to}, limits).back();
  limits.travelRadPerS2 = 1.4;
  EXPECT_NEAR(motion::timesOf({from, to}, limits).back(), 2.0 / 1.35 + 1.35 / 1.4, 1e-6);
  EXPECT_LT(before, 2.0);
}

// Joint moves on one line take as long as one; where they bend the arm stops, and both take as long
// as each alone.
TEST(Timing, JointMovesStopWhereTheyBend) {
  TimedPoint from, middle, to, offset;
  from.q = middle.q = to.q = robot::JointVector::Zero(2);
  middle.jointMove = to.jointMove = true;
  middle.q[1] = 1.0;
  to.q[1] = 2.0;
  offset = to;
  offset.q = Eigen::Vector2d(1.0, 1.0);
  motion::TimingLimits limits = limitsOf(2);
  limits.travelRadPerS2 = 1.4;
  middle.tip = {300, 0, 0}; // for any motion of the tip
  to.tip = {310, 0, 0};
  EXPECT_NEAR(motion::timesOf({from, middle, to}, limits).back(),
              motion::timesOf({from, to}, limits).back(), 1e-9);
  EXPECT_NEAR(motion::timesOf({from, middle, offset}, limits).back(),
              motion::timesOf({from, middle}, limits).back() +
                  motion::timesOf({middle, offset}, limits).back(),
              1e-9);
}

// Through a corner as fast as the circle that cuts it by cornerMm allows; straight on at speed, and
// back or where it is to stop from rest.
TEST(Timing, CornerSpeedFollowsTheAllowedCut) {
  const motion::TimingLimits limits = limitsOf(2);
  const double a = limits.accelerationMmPerS2, v = 40.0, leg = 15.0;
  for (const double angle : {0.0, 0.3, 0.5 * base::kPi, 2.5, base::kPi})
    for (const bool stop : {false, true}) {
      SCOPED_TRACE(angle);
      std::vector<TimedPoint> points(3);
      for (TimedPoint& p : points) {
        p.q = robot::JointVector::Zero(2);
        p.speedMmPerS = v;
      }
      points[1].tip = {leg, 0, 0};
      points[2].tip = {leg + leg * std::cos(angle), leg * std::sin(angle), 0};
      points[1].stop = stop;
      // The circle's distance from the corner is its radius by 1 / cos(turn / 2) less one.
      const double c = std::cos(0.5 * angle);
      const double radius = c < 1.0 - 1e-9 ? limits.cornerMm / (1.0 / c - 1.0) : 1e9;
      const double corner = stop ? 0.0 : std::min(v, std::sqrt(a * std::max(radius, 0.0)));
      const double ramps = (v * v + v * v - corner * corner) / (2.0 * a);
      const double one = v / a + (v - corner) / a + (leg - ramps) / v;
      EXPECT_NEAR(motion::timesOf(points, limits).back(), 2.0 * one, 1e-6);
      EXPECT_NEAR(motion::timesOf(points, limits)[1], one, 1e-6);
    }
}

// The same from any start: on, but not back, not aside, and not on the spot.
TEST(Timing, JointMovesGoOnFromAnyPose) {
  const motion::TimingLimits limits = limitsOf(2);
  const auto stands = [&](const Eigen::Vector2d& begin, const Eigen::Vector2d& first,
                          const Eigen::Vector2d& second) {
    TimedPoint a, b, c;
    a.q = begin;
    b.q = begin + first;
    c.q = begin + first + second;
    b.jointMove = c.jointMove = true;
    const double apart =
        motion::timesOf({a, b}, limits).back() + motion::timesOf({b, c}, limits).back();
    const double both = motion::timesOf({a, b, c}, limits).back();
    EXPECT_LE(both, apart + 1e-9);
    return both > apart - 1e-9;
  };
  for (const Eigen::Vector2d& begin :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(1.5, -2.0), Eigen::Vector2d(-3.0, 0.4)}) {
    const Eigen::Vector2d direction(0.6, -0.8), across(0.8, 0.6);
    EXPECT_FALSE(stands(begin, direction, direction));
    EXPECT_FALSE(stands(begin, direction, 0.25 * direction));
    EXPECT_TRUE(stands(begin, direction, -0.25 * direction)) << "turns back";
    EXPECT_TRUE(stands(begin, direction, across));
    EXPECT_TRUE(stands(begin, direction, direction + 0.1 * across));
    EXPECT_TRUE(stands(begin, direction, -direction)) << "to where it began";
  }
}

// A straight move during which a joint is far faster than from end to end, as near a singular pose:
// it takes as long as at that speed all the way.
TEST(Timing, MoveIsTimedByTheGreatestSpeedOfAJoint) {
  TimedPoint from, to;
  from.q = to.q = robot::JointVector::Zero(2);
  to.tip = {1, 0, 0};
  to.speedMmPerS = 100;
  to.q[1] = 0.01;
  const motion::TimingLimits limits = limitsOf(2);
  const double even = motion::timesOf({from, to}, limits).back();
  to.peakDisplacement = robot::JointVector::Zero(2);
  to.peakDisplacement[1] = 2.7;
  EXPECT_GE(motion::timesOf({from, to}, limits).back(), 2.7 / (0.9 * 3.0));
  EXPECT_LT(even, 0.5);
}

// A fixed nozzle over a turning rod, r 2.75: its way is the tip's over the part, and the ramps are
// those of the rod where it is the slower one.
TEST(Timing, RodTurnsUnderTheTip) {
  const double r = 2.75, speed = 20.0;
  std::vector<TimedPoint> points;
  for (int i = 0; i <= 2000; ++i) {
    const double a = 0.01 * i;
    TimedPoint p;
    p.q = robot::JointVector::Zero(2);
    p.q[1] = -a;
    p.tip = {0, r * std::cos(a), r * std::sin(a)};
    p.speedMmPerS = speed;
    points.push_back(p);
  }
  motion::TimingLimits limits = limitsOf(2);
  limits.arm = 1;
  limits.joints[1] = {-100, 100, 12.0, 1000.0};
  const auto straight = [&](double acceleration) {
    return 2000 * 2 * r * std::sin(0.005) / speed + speed / acceleration;
  };
  EXPECT_NEAR(motion::timesOf(points, limits).back(), straight(500), 1e-3);
  limits.joints[1].acceleration = 50.0; // 45 of it used
  EXPECT_NEAR(motion::timesOf(points, limits).back(), straight(45 * r), 0.05);
  limits.joints[1].velocity = 4.0; // 3.6 used, 9.9 mm/s
  EXPECT_NEAR(motion::timesOf(points, limits).back(), 20.0 / 3.6 + 3.6 / 45, 0.05);
}

TEST(Timing, KeepsEveryLimit) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 100; ++n) {
    std::vector<TimedPoint> points(60);
    robot::JointVector q = robot::JointVector::Zero(6);
    Eigen::Vector3d tip = Eigen::Vector3d::Zero();
    for (auto& p : points) {
      for (int j = 0; j < 6; ++j)
        q[j] += (n % 3 == 0 ? 0.1 : 0.01) * normal(engine);
      tip += (n % 2 ? 1.0 : 0.2) * Eigen::Vector3d(normal(engine), normal(engine), normal(engine));
      p.q = q;
      p.tip = tip;
      p.speedMmPerS = n % 5 == 0 ? 100 : 20;
      p.jointMove = n % 7 == 0;
    }
    const auto limits = limitsOf(6);
    const auto times = motion::timesOf(points, limits);
    robot::JointVector last = robot::JointVector::Zero(6);
    double lastDt = 0.0;
    for (std::size_t i = 1; i <= points.size(); ++i) {
      const bool end = i == points.size();
      const double dt = end ? 0.0 : times[i] - times[i - 1];
      robot::JointVector v = robot::JointVector::Zero(6);
      if (!end) {
        ASSERT_GT(dt, 0.0);
        v = (points[i].q - points[i - 1].q) / dt;
        EXPECT_LE(v.cwiseAbs().maxCoeff(), 3.0);
        if (!points[i].jointMove) {
          EXPECT_LE((points[i].tip - points[i - 1].tip).norm() / dt,
                    points[i].speedMmPerS * (1 + 1e-9));
        }
      }
      EXPECT_LE((v - last).cwiseAbs().maxCoeff() / (0.5 * (dt + lastDt)), 14.0) << n << " " << i;
      last = v;
      lastDt = dt;
    }
  }
}

// A joint that follows t^3 has the jerk 6 everywhere but where it starts and stops.
TEST(Timing, JerkOfACubic) {
  std::vector<robot::JointVector> points;
  std::vector<double> times;
  for (int i = 0; i <= 20; ++i) {
    const double t = 0.1 * i;
    points.emplace_back(robot::JointVector::Constant(1, t * t * t));
    times.push_back(t);
  }
  points.resize(20); // the stop at the end has a jerk of its own
  times.resize(20);
  const auto jerk = motion::jerkOf(points, times);
  EXPECT_GE(jerk.maxAbs[0], 6.0);
  EXPECT_GE(jerk.sumSquared, 17 * 36.0);
}

TEST(EvenTurns, KeepsLinesAndSolvesItsEquations) {
  std::vector<double> line;
  for (int i = 0; i < 50; ++i)
    line.push_back(0.3 * i - 2);
  const auto same = motion::evened(line, 200);
  for (std::size_t i = 0; i < line.size(); ++i)
    EXPECT_NEAR(same[i], line[i], 1e-9);
  std::mt19937 engine(1);
  std::normal_distribution<double> normal;
  std::vector<double> y;
  for (int i = 0; i < 40; ++i)
    y.push_back(normal(engine));
  const auto x = motion::evened(y, 7.0);
  // x + lambda D'D x = y, written out.
  for (std::size_t i = 0; i < y.size(); ++i) {
    double sum = x[i];
    for (std::size_t k = 0; k + 2 < y.size(); ++k) {
      const double second = x[k] - 2 * x[k + 1] + x[k + 2];
      if (i == k || i == k + 2)
        sum += 7.0 * second;
      else if (i == k + 1)
        sum -= 14.0 * second;
    }
    EXPECT_NEAR(sum, y[i], 1e-9);
  }
}
