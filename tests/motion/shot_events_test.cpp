// Shots into pockets in a trajectory.
#include "motion/shot_events.h"

#include "plan/finding_kinds.h"

#include <gtest/gtest.h>
#include <string>

namespace voluta::motion {
namespace {

using Eigen::Vector3d;

plan::ToolPlan shotPlan() {
  plan::ToolPlan plan;
  for (const double z : {4.0, 4.0, 22.0, 19.4, 22.0}) {
    plan.position.emplace_back(z > 10.0 ? 1.0 : 0.0, 0.0, z);
    plan.direction.emplace_back(0, 0, 1);
    plan.widthMm.push_back(6.0f);
    plan.heightMm.push_back(5.0f);
    plan.speedMmPerS.push_back(10.0f);
  }
  plan.paths = {{.first = 0, .count = 2}, {.first = 2, .count = 3, .kind = plan::PathKind::Shot}};
  return plan;
}

Run runOf(std::size_t path, const std::vector<std::size_t>& waypoints) {
  Run run;
  run.path = path;
  for (const std::size_t w : waypoints) {
    run.points.emplace_back();
    run.points.back().waypoint = w;
  }
  return run;
}

TEST(ShotEvents, TheShotFlowsFromTheLowestPoint) {
  const plan::ToolPlan plan = shotPlan();
  EXPECT_EQ(plan.shotAt(plan.paths[1]), 3u);
  EXPECT_NEAR(plan.shotMm3(plan.paths[1]), 0.25 * 3.14159265 * 36.0 * 5.0, 1e-4);
  EXPECT_EQ(shotPoint(plan, runOf(1, {2, 3, 4})), 1u);
  EXPECT_EQ(shotPoint(plan, runOf(1, {2, plan::kNoWaypoint, 3, 4})), 2u);
  EXPECT_EQ(shotPoint(plan, runOf(0, {0, 1})), std::nullopt) << "a bead";
  EXPECT_EQ(shotPoint(plan, runOf(1, {2, 3})), std::nullopt) << "no way out of the pocket";
  EXPECT_EQ(shotPoint(plan, runOf(1, {2, 4})), std::nullopt) << "the pocket is out of reach";
}

TEST(ShotEvents, LastAsLongAsTheFlowNeeds) {
  process::Process process;
  process.maxFlowMm3PerS = 40.0;
  const auto events = [&](const MotionOptions& options) {
    plan::Trajectory t;
    t.timeS = {0.0, 1.0};
    const double seconds = addShotEvents(t, 200.0, process, options);
    double sum = 0.0;
    for (const plan::TrajectoryEvent& e : t.events) {
      EXPECT_EQ(e.point, 2u);
      sum += e.seconds;
    }
    EXPECT_DOUBLE_EQ(sum, seconds);
    return t.events;
  };
  MotionOptions options;
  ASSERT_EQ(events(options).size(), 1u);
  EXPECT_DOUBLE_EQ(events(options)[0].seconds, 5.0);
  options.shot.flowMm3PerS = 10.0;
  options.shot.waitS = 1.5;
  ASSERT_EQ(events(options).size(), 2u);
  EXPECT_DOUBLE_EQ(events(options)[0].seconds, 20.0);
  EXPECT_DOUBLE_EQ(events(options)[0].volumeMm3, 200.0);
  EXPECT_EQ(events(options)[1].kind, plan::EventKind::Wait);
  options.shot.flowMm3PerS = 400.0;
  EXPECT_DOUBLE_EQ(events(options)[0].seconds, 5.0) << "beyond the process";
}

// 212 mm3 at 12 mm3/s are 17.7 s in a pocket that a nozzle may stay in for 4 s.
TEST(ShotEvents, LongShotsGiveAFinding) {
  process::Process process;
  process.maxFlowMm3PerS = 12.0;
  const plan::ToolPlan plan = shotPlan();
  const auto findingOf = [&](double volumeMm3, double waitS) {
    plan::Trajectory t;
    t.timeS = {0.0, 1.0};
    t.waypoint = {2, 3};
    MotionOptions options;
    options.shot.waitS = waitS;
    addShotEvents(t, volumeMm3, process, options);
    return longShots(t, plan);
  };
  const auto finding = findingOf(212.0, 0.0);
  ASSERT_TRUE(finding);
  EXPECT_FALSE(finding->blocking);
  EXPECT_EQ(finding->where, plan.position[3]);
  EXPECT_NE(plan::englishReason(*finding).find("1 shot into a pocket lasts up to 17.7"),
            std::string::npos)
      << plan::englishReason(*finding);
  EXPECT_FALSE(findingOf(36.0, 0.0)) << "3 s";
  EXPECT_TRUE(findingOf(36.0, 1.5)) << "the wait counts too";
}

} // namespace
} // namespace voluta::motion
