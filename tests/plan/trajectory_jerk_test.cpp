#include "plan/trajectory_jerk.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace voluta;

namespace {

// One joint at t^3 / 6 after a second's start, so that its jerk is 1 inside.
plan::Trajectory cubic(std::size_t count, double stepS) {
  plan::Trajectory t;
  t.dof = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double time = stepS * static_cast<double>(i);
    t.joints.push_back(std::pow(time, 3) / 6.0);
    t.timeS.push_back(time);
    t.move.push_back(plan::MoveKind::Print);
  }
  return t;
}

} // namespace

TEST(TrajectoryJerk, IsOneAlongACubic) {
  const auto jerks = plan::jerkAlong(cubic(40, 0.05));
  ASSERT_EQ(jerks.size(), 1u);
  ASSERT_EQ(jerks[0].size(), 40u);
  for (std::size_t i = 4; i < 36; ++i)
    EXPECT_NEAR(jerks[0][i], 1.0f, 1e-3f) << i;
  EXPECT_GT(std::abs(jerks[0][39]) + std::abs(jerks[0][38]), 10.0f) << "it stops at once";
}

// From 1 to 3 within a second (Jerk.OfOneStepFromRestToRest): 16, then -16.
TEST(TrajectoryJerk, OfOneStepFromRestToRest) {
  plan::Trajectory t;
  t.dof = 1;
  t.joints = {1.0, 3.0};
  t.timeS = {0.0, 1.0};
  t.move = {plan::MoveKind::Joint, plan::MoveKind::Joint};
  const auto jerks = plan::jerkAlong(t);
  EXPECT_NEAR(std::abs(jerks[0][0]), 16.0f, 1e-4f);
  EXPECT_NEAR(std::abs(jerks[0][1]), 16.0f, 1e-4f);
}

TEST(TrajectoryJerk, OfNothingIsNothing) {
  EXPECT_TRUE(plan::jerkAlong({}).empty());
  const auto still = plan::jerkAlong(cubic(5, 0.0));
  for (const float jerk : still.at(0))
    EXPECT_EQ(jerk, 0.0f);
}
