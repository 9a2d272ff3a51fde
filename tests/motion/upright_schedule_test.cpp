// A tilting and turning table that follows a path's directions.
#include "base/units.h"
#include "motion/upright_schedule.h"
#include "process/process.h"
#include "robot/cell.h"
#include "robot/upright_axes.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>

namespace voluta::motion {
namespace {

using Eigen::Vector3d;
using robot::JointVector;

class UprightSchedule : public ::testing::Test {
protected:
  void SetUp() override { setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1); }
  static robot::Cell cell() {
    platform::PlatformSolid plate;
    plate.polygon = {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
    return robot::loadCell("five-axis", process::loadProcess("fdm-1.0"), plate);
  }
  static Vector3d leaning(double tiltDeg, double aroundDeg) {
    const double t = base::degreesToRadians(tiltDeg), a = base::degreesToRadians(aroundDeg);
    return {std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), std::cos(t)};
  }
  static plan::ToolPlan planOf(const std::vector<Vector3d>& directions) {
    plan::ToolPlan plan;
    for (const Vector3d& d : directions) {
      plan.position.emplace_back(0.1 * static_cast<double>(plan.position.size()), 0, 10);
      plan.direction.push_back(d);
    }
    return plan;
  }
  static std::vector<JointVector> schedule(const std::vector<Vector3d>& directions) {
    return uprightSchedule(planOf(directions), cell(), 0, directions.size(), JointVector::Zero(2));
  }
  static double tiltOf(const Vector3d& direction, const JointVector& axes) {
    const robot::Cell five = cell();
    JointVector q = five.home();
    q.tail(2) = axes;
    return std::acos(std::min(1.0, (five.base_T_work(q).linear() * direction).z()));
  }
};

// Wandering directions: all upright, within limits, and no axis jumps where the direction is clear
// of the turning axis.
TEST_F(UprightSchedule, TurnsEveryDirectionUpright) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> step(0.0, 0.02);
  const robot::Cell five = cell();
  for (int n = 0; n < 100; ++n) {
    Vector3d d = leaning(5.0 + n, 40.0 * n);
    std::vector<Vector3d> directions;
    for (int i = 0; i < 60; ++i) {
      directions.push_back(d);
      d = (d + Vector3d(step(random), step(random), step(random))).normalized();
    }
    const std::vector<JointVector> axes = schedule(directions);
    ASSERT_EQ(axes.size(), directions.size()) << n;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      ASSERT_LE(tiltOf(directions[i], axes[i]), robot::kAlongAxisRad) << n << ' ' << i;
      ASSERT_LE(std::abs(axes[i][0]), five.externalAxes()[0].limits.max);
      const double clear = std::hypot(directions[i].x(), directions[i].y());
      if (i > 0 && clear > 0.2) {
        ASSERT_LT((axes[i] - axes[i - 1]).cwiseAbs().maxCoeff(), 0.15 / clear) << n << ' ' << i;
      }
    }
  }
}

// Over the plate's normal and down the other side: the tilt changes its sign, the turn stays.
TEST_F(UprightSchedule, TiltsThroughTheNormal) {
  std::vector<Vector3d> over;
  for (double t = 60.0; t >= -60.0; t -= 1.0)
    over.push_back(leaning(t, 40.0));
  const std::vector<JointVector> axes = schedule(over);
  ASSERT_EQ(axes.size(), over.size());
  for (const JointVector& a : axes)
    EXPECT_NEAR(a[1], axes.front()[1], 1e-9);
  EXPECT_NEAR(axes.front()[0], -axes.back()[0], 1e-9);
}

// On a flat stretch between two sides the table turns evenly.
TEST_F(UprightSchedule, TurnsEvenlyWhereTheTurnIsFree) {
  std::vector<Vector3d> path(10, leaning(30, 0));
  path.insert(path.end(), 30, Vector3d::UnitZ());
  path.insert(path.end(), 10, leaning(30, 60));
  const std::vector<JointVector> axes = schedule(path);
  ASSERT_EQ(axes.size(), path.size());
  for (std::size_t i = 10; i <= 40; ++i)
    EXPECT_NEAR(std::abs(axes[i][1] - axes[i - 1][1]), base::degreesToRadians(60.0 / 31), 1e-9);
  // Flat from its beginning: the table waits in the first required angle.
  path.erase(path.begin(), path.begin() + 10);
  for (std::size_t i = 0; i < 30; ++i)
    EXPECT_EQ(schedule(path)[i][1], schedule(path)[30][1]);
}

// A whole turn about the normal turns the table by one, not back and forth.
TEST_F(UprightSchedule, FollowsThePathAround) {
  std::vector<Vector3d> around;
  for (int i = 0; i <= 720; i += 2)
    around.push_back(leaning(40, i));
  const std::vector<JointVector> axes = schedule(around);
  ASSERT_EQ(axes.size(), around.size());
  EXPECT_NEAR(std::abs(axes.back()[1] - axes.front()[1]), 2.0 * base::kTwoPi, 1e-9);
}

TEST_F(UprightSchedule, EndsWhereTheTableCannotTilt) {
  std::vector<Vector3d> down;
  for (int t = 90; t <= 150; ++t)
    down.push_back(leaning(t, 20));
  EXPECT_EQ(schedule(down).size(), 31u); // up to 120 degrees
  EXPECT_TRUE(schedule({leaning(150, 0)}).empty());
}

} // namespace
} // namespace voluta::motion
