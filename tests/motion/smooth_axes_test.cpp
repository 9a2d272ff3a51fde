// External axes in the smoothed motion: a tilting and turning plate, and one that slides.
#include "base/units.h"
#include "motion/external_axes.h"
#include "motion/motion_scene.h"
#include "motion/sample_plans.h"
#include "motion/sequence.h"
#include "motion/smooth_points.h"

#include <algorithm>
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

// A nozzle on one spot of a plate that external axes carry to and fro, the arm going after it.
std::vector<RunPoint> carriedAbout(const robot::Cell& cell, std::size_t count, double rad) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> chance(-0.1, 0.1);
  std::vector<RunPoint> points;
  const motion::RobotState home = motion::stateAt(cell, cell.home());
  std::vector<JointVector> scratch;
  JointVector q = cell.home();
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    RunPoint p;
    p.at = home;
    p.at.axes = motion::axesOf(cell, cell.home());
    for (Eigen::Index k = 0; k < p.at.axes.size() && i > 0 && i + 1 < count; ++k)
      p.at.axes[k] += robot::fromAngle(cell.externalAxes()[static_cast<std::size_t>(k)].limits.kind,
                                       rad * (std::sin(base::kPi * t) + chance(random)) *
                                           (k == 0 ? 1.0 : -0.5));
    if (!motion::solveNear(cell, home.tip, home.tool, motion::withAxes(cell, q, p.at.axes), 0.5,
                           scratch, p.at.q))
      return {};
    q = p.at.q;
    points.push_back(p);
  }
  return points;
}

struct AxesCell {
  process::Process process = process::loadProcess("fdm-1.0");
  robot::Cell cell;
  robot::ArmTwists twists;
  explicit AxesCell(const std::string& id)
      : cell(robot::loadCell(id, process, test::disc(100.0))), twists(*cell.robot().kinematics) {}
};

} // namespace

class SmoothAxes : public testing::TestWithParam<const char*> {};

TEST_P(SmoothAxes, RatesAreTheDerivativesOfTheInverse) {
  const AxesCell c(GetParam());
  const auto points = carriedAbout(c.cell, 25, 0.1);
  ASSERT_EQ(points.size(), 25u);
  const motion::RotationSmoother smoother(c.cell, c.twists, points, evenTimes(25, 0.05), 0.05, 0.3);
  auto at = smoother.start(onThreads(1));
  smoother.smooth(at, std::vector<RotationHold>(at.size()), {2, 0.0, 0.3}, onThreads(1));
  constexpr double kStep = 1e-5;
  std::vector<JointVector> scratch;
  const Eigen::Index arm = c.cell.armDof(), axes = c.cell.dof() - arm;
  double furthest = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    ASSERT_EQ(at[i].rate.rows(), arm + axes);
    ASSERT_EQ(at[i].rate.cols(), 3 + axes);
    furthest = std::max(furthest, at[i].offset.norm());
    for (Eigen::Index k = 0; k < axes; ++k) {
      const auto moved = [&](double by, JointVector& q) {
        JointVector near = at[i].q;
        near[arm + k] += by;
        return motion::solveNear(c.cell, points[i].at.tip, at[i].tool(points[i].at.tool), near, 0.1,
                                 scratch, q);
      };
      JointVector more, less;
      ASSERT_TRUE(moved(kStep, more) && moved(-kStep, less));
      EXPECT_LT(((more - less) / (2.0 * kStep) - at[i].rate.col(3 + k)).norm(),
                1e-5 * (1.0 + at[i].rate.col(3 + k).norm()))
          << i << " " << k;
    }
  }
  EXPECT_GT(furthest, 0.01); // they moved indeed
}

// Standing still is without jerk, and where axes have the room for it they come to that.
TEST_P(SmoothAxes, NeedlessMotionOfAxesIsRemoved) {
  const AxesCell c(GetParam());
  constexpr std::size_t kPoints = 41;
  constexpr double kRad = 0.05;
  const auto points = carriedAbout(c.cell, kPoints, kRad);
  ASSERT_EQ(points.size(), kPoints);
  std::vector<RotationHold> holds(kPoints);
  holds.front().stay = holds.back().stay = motion::kHeld;
  const auto smoothed = [&](double axesRad, int threads) {
    const motion::RotationSmoother smoother(c.cell, c.twists, points, evenTimes(kPoints, 0.05), 0.0,
                                            axesRad);
    auto at = smoother.start(onThreads(threads));
    smoother.smooth(at, holds, {200, 0.0, 0.3}, onThreads(threads));
    return at;
  };
  const auto wide = smoothed(4.0 * kRad, 2), alone = smoothed(4.0 * kRad, 1);
  for (std::size_t i = 0; i < kPoints; ++i) {
    EXPECT_LT((wide[i].q - c.cell.home()).norm(), 1e-3) << i;
    EXPECT_EQ(wide[i].q, alone[i].q) << "threads";
  }
  const auto narrow = smoothed(0.5 * kRad, 1);
  double maximum = 0.0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    EXPECT_LT(largestOff(c.cell, points[i], narrow[i]), 1e-6);
    for (Eigen::Index k = 0; k < narrow[i].offset.size(); ++k) {
      const auto kind = c.cell.externalAxes()[static_cast<std::size_t>(k)].limits.kind;
      maximum = std::max(maximum, robot::asAngle(kind, std::abs(narrow[i].offset[k])));
      EXPECT_NEAR(narrow[i].q[c.cell.armDof() + k], points[i].at.axes[k] + narrow[i].offset[k],
                  1e-12);
    }
  }
  EXPECT_LE(maximum, 0.5 * kRad);
  EXPECT_GT(maximum, 0.4 * kRad);
}

// For any range that they may use.
TEST_P(SmoothAxes, LimitsAreKept) {
  const AxesCell c(GetParam());
  const auto points = carriedAbout(c.cell, 30, 0.02);
  ASSERT_EQ(points.size(), 30u);
  const motion::RotationSmoother smoother(c.cell, c.twists, points, evenTimes(30, 0.05), 0.0,
                                          100.0);
  auto at = smoother.start(onThreads(1));
  smoother.smooth(at, std::vector<RotationHold>(30), {}, onThreads(1));
  for (const TurnedPoint& p : at)
    for (Eigen::Index j = 0; j < p.q.size(); ++j) {
      EXPECT_GE(p.q[j], c.cell.limits()[static_cast<std::size_t>(j)].min);
      EXPECT_LE(p.q[j], c.cell.limits()[static_cast<std::size_t>(j)].max);
    }
}

INSTANTIATE_TEST_SUITE_P(Cells, SmoothAxes, testing::Values("irb1200-irbp", "kr10-r1100-slide"),
                         [](const auto& cell) {
                           std::string name = cell.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });
