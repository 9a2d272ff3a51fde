// Motions of an arm that is not six turning axes: four, one of which slides, the nozzle upright.
#include "collision/growing_part.h"
#include "motion/joint_margins.h"
#include "motion/ladder/joint_costs.h"
#include "motion/motion.h"
#include "motion/sample_plans.h"
#include "motion/timing.h"
#include "motion/transfers/rrt_connect.h"
#include "plan/finding_kinds.h"
#include "process/tooling.h"

#include "base/run_context.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace voluta;
using Eigen::Vector3d;
using robot::JointKind;
using robot::JointVector;

namespace {

struct Moved {
  plan::ToolPlan plan;
  process::Process process = process::loadProcess("fdm-1.0");
  robot::Cell cell = robot::loadCell("t3", process, test::disc(30));
  collision::GrowingPart part;
  motion::MotionResult result;

  explicit Moved(plan::ToolPlan p)
      : plan(std::move(p)), part(plan, 0.45, {}),
        result(motion::MotionPlanner(plan, cell, process::Tooling(process), part, {}).plan({})) {}
  JointVector at(std::size_t i) const {
    const plan::Trajectory& t = result.trajectory;
    return Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
  }
};

JointVector joints(std::initializer_list<double> values) {
  JointVector q(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), q.begin());
  return q;
}

} // namespace

TEST(ScaraMotion, ACylinderIsPrintedWithinLimits) {
  const Moved m(test::cylinder(20, 12));
  for (const auto& f : m.result.findings)
    ADD_FAILURE() << plan::englishReason(f);
  const plan::Trajectory& t = m.result.trajectory;
  ASSERT_EQ(t.dof, 4);
  EXPECT_EQ(m.result.statistics.waypoints, m.plan.waypointCount());
  EXPECT_EQ(m.result.statistics.splits, 0u);
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    const Eigen::Isometry3d pose = m.cell.work_T_tool(m.at(i));
    EXPECT_LT((pose.linear().col(2) + Vector3d::UnitZ()).norm(), 1e-9);
    if (const std::size_t w = t.waypoint[i]; w != plan::kNoWaypoint) {
      EXPECT_LT((pose.translation() - m.plan.position[w]).norm(), 1e-6);
    }
    for (int j = 0; j < 4; ++j) {
      const robot::JointLimits& limit = m.cell.limits()[static_cast<std::size_t>(j)];
      EXPECT_GE(t.at(i)[j], limit.min);
      EXPECT_LE(t.at(i)[j], limit.max);
      if (i > 0) {
        const double step = std::abs(t.at(i)[j] - t.at(i - 1)[j]);
        EXPECT_LE(step / (t.timeS[i] - t.timeS[i - 1]), limit.velocity);
        if (t.move[i] == plan::MoveKind::Print) {
          EXPECT_LE(robot::asAngle(limit.kind, step), 0.25);
        }
      }
    }
  }
  const auto margins = motion::marginsOf(t, m.cell, {});
  ASSERT_EQ(margins.joints.size(), 4u);
  EXPECT_GE(margins.joints[2].rad, 0.0);
  EXPECT_GT(margins.isotropy, 0.05);
}

// One finding for all leaning directions, independent of the rest.
TEST(ScaraMotion, LeaningDirectionsGiveOneFinding) {
  plan::ToolPlan plan = test::cylinder(15, 6);
  std::size_t leaning = 0;
  for (std::size_t i = 100; i < plan.waypointCount(); i += 7, ++leaning)
    plan.direction[i] = Vector3d(0.1, 0, 1).normalized();
  const Moved m(std::move(plan));
  ASSERT_GT(leaning, 20u);
  std::size_t reported = 0;
  for (const auto& f : m.result.findings)
    if (f.kind == plan::FindingKind::StaysUpright) {
      ++reported;
      EXPECT_EQ(f.count, leaning);
      EXPECT_TRUE(f.blocking);
      ASSERT_TRUE(f.where);
      EXPECT_EQ(*f.where, m.plan.position[100]);
      EXPECT_NE(plan::englishReason(f).find("keeps the nozzle upright"), std::string::npos);
      EXPECT_NE(plan::englishRemedy(f).find("mode flat"), std::string::npos);
    }
  EXPECT_EQ(reported, 1u);
  EXPECT_GE(m.result.statistics.unreachable, leaning);
}

// The slide's lever makes its steps comparable: a tree that has to go round by it gets there.
TEST(ScaraMotion, TreeFindsAWayRoundByTheSlide) {
  const std::vector<robot::JointLimits> limits{{-2, 2, 1, 1},
                                               {-150, 0, 1000, 5000, JointKind::Sliding}};
  // A wall about joint 1 = 0 that is open above 30 mm below the top.
  const auto free = [](const JointVector& q) { return std::abs(q[0]) > 0.3 || q[1] > -30.0; };
  const auto segmentFree = [&](const JointVector& a, const JointVector& b) {
    for (int k = 0; k <= 400; ++k)
      if (!free(a + k / 400.0 * (b - a)))
        return false;
    return true;
  };
  const JointVector from = joints({-1, -140}), to = joints({1, -140});
  const auto path = motion::treePath(from, to, limits, free, segmentFree, {}, {});
  ASSERT_GE(path.size(), 3u);
  EXPECT_EQ(path.front(), from);
  EXPECT_EQ(path.back(), to);
  double highest = -150.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_GE(path[i][1], -150.0);
    EXPECT_LE(path[i][1], 0.0);
    highest = std::max(highest, path[i][1]);
    if (i > 0) {
      EXPECT_TRUE(segmentFree(path[i - 1], path[i]));
    }
  }
  EXPECT_GT(highest, -30.0);
}

TEST(ScaraMotion, TimesKeepASlidesLimits) {
  motion::TimingLimits limits;
  limits.joints = {{-3, 3, 6, 25}, {-150, 0, 100, 400, JointKind::Sliding}};
  limits.jointFraction = 1.0;
  std::vector<motion::TimedPoint> points(2);
  points[0].q = joints({0, 0});
  points[1].q = joints({0, -100});
  points[1].jointMove = true;
  points[0].stop = points[1].stop = true;
  // Half of 100 mm/s at most, and mean velocity over half the time no more than 400 mm/s2.
  const double alone = motion::timesOf(points, limits).back();
  EXPECT_GE(alone, 2.0);
  EXPECT_LT(alone, 4.0);
  // A travel's acceleration holds for it as for a turn of as much.
  limits.travelRadPerS2 = 0.5; // 50 mm/s2
  const double slow = motion::timesOf(points, limits).back();
  EXPECT_GE(slow, 2.0 * std::sqrt(100.0 / 50.0) - 1e-9);
  points[1].q = joints({1, 0});
  EXPECT_NEAR(motion::timesOf(points, limits).back(), 2.0 * std::sqrt(1.0 / 0.5), 0.3);
}

TEST(ScaraMotion, CostsCountASlideByItsLever) {
  const std::vector<robot::JointLimits> limits{{-4, 4, 1, 1}, {-150, 0, 1, 1, JointKind::Sliding}};
  const double slide = motion::startCost(joints({0, 0}), joints({0, -50}), limits);
  EXPECT_NEAR(slide, motion::startCost(joints({0, 0}), joints({0.5, 0}), limits), 1e-12);
  // No whole turns off a slide.
  EXPECT_NEAR(motion::startCost(joints({0, -140}), joints({0, -140 + 6.283185307}), limits),
              0.06283185307, 1e-9);
}
