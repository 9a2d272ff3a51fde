#include "base/run_context.h"
#include "motion/motion_options.h"
#include "pipeline/part_motion.h"
#include "pipeline/stages.h"
#include "process/process.h"
#include "process/tooling.h"
#include "robot/cell.h"

#include "motion/motion.h"
#include "motion/sample_plans.h"
#include "plan/blocking_share.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

class Rings : public ::testing::Test {
protected:
  // The growing part is built anew for every round: its contents do not depend on when.
  static bool prints(const MotionStage& stage, std::size_t waypoint) {
    return std::ranges::count(stage.trajectory->waypoint, waypoint) > 0;
  }

  const plan::ToolPlan plan_ = test::cylinder(15, 6);
  const process::Process process_ = process::loadProcess("fdm-1.0");
  const platform::PlatformSolid plate_{test::disc(20)};
  const robot::Cell cell_ = robot::loadCell("ur5-fixed", process_, plate_);
};

TEST_F(Rings, AreReplannedWithoutTheAvoidedWaypoints) {
  PartMotion moving(plan_, plate_, cell_, process::Tooling(process_), {}, {}, {});
  const auto all = moving.plan({});
  EXPECT_EQ(all->report.waypoints, plan_.waypointCount());
  EXPECT_TRUE(all->findings.empty());
  const auto less = moving.planWithout({40}, {});
  EXPECT_EQ(less->report.waypoints, plan_.waypointCount() - 1);
  EXPECT_TRUE(prints(*all, 40));
  EXPECT_FALSE(prints(*less, 40));
  const auto reduced = moving.planWithout({41}, {});
  EXPECT_EQ(reduced->report.waypoints, plan_.waypointCount() - 2);

  // As the planner has it with one growing part for all rounds.
  const collision::GrowingPart growing(
      plan_, collision::growingPitch(plan_, process::Tooling(process_)), {});
  motion::MotionPlanner planner(plan_, cell_, process::Tooling(process_), growing, {});
  EXPECT_EQ(planner.plan({}).trajectory.joints, all->trajectory->joints);
  EXPECT_EQ(planner.planWithout({40}, {}).trajectory.joints, less->trajectory->joints);
  EXPECT_EQ(planner.planWithout({41}, {}).trajectory.joints, reduced->trajectory->joints);
}

TEST_F(Rings, TakeAPartThatIsGrownAlready) {
  const auto grown = std::make_shared<const collision::GrowingPart>(
      plan_, collision::growingPitch(plan_, process::Tooling(process_)), base::RunContext{});
  PartMotion taking(plan_, plate_, cell_, process::Tooling(process_), {}, grown, {}),
      laying(plan_, plate_, cell_, process::Tooling(process_), {}, {}, {});
  EXPECT_EQ(taking.plan({})->trajectory->joints, laying.plan({})->trajectory->joints);
  EXPECT_EQ(taking.planWithout({40}, {})->trajectory->joints,
            laying.planWithout({40}, {})->trajectory->joints);
}

TEST_F(Rings, AreGivenUpOnceMoreIsLostThanMayBeLeftOut) {
  plan::ToolPlan upsideDown = plan_;
  const plan::ToolPath& last = upsideDown.paths.back();
  for (std::size_t w = last.first; w < last.first + last.count; ++w)
    upsideDown.direction[w] = -Eigen::Vector3d::UnitZ();
  const auto whole =
      PartMotion(upsideDown, plate_, cell_, process::Tooling(process_), {}, {}, {}).plan({});
  ASSERT_NE(whole->trajectory, nullptr);
  const auto tried = PartMotion(upsideDown, plate_, cell_, process::Tooling(process_), {}, {}, {})
                         .plan({}, plan::kBlockingShare);
  EXPECT_EQ(tried->trajectory, nullptr);
  const auto blocking = std::ranges::find_if(whole->findings, &plan::Finding::blocking);
  ASSERT_NE(blocking, whole->findings.end());
  ASSERT_FALSE(tried->findings.empty());
  EXPECT_EQ(tried->findings.front().kind, blocking->kind);
  EXPECT_TRUE(tried->findings.front().blocking);
}

TEST_F(Rings, MoveTheSameWayWhereNothingIsLost) {
  PartMotion tried(plan_, plate_, cell_, process::Tooling(process_), {}, {}, {}),
      whole(plan_, plate_, cell_, process::Tooling(process_), {}, {}, {});
  EXPECT_EQ(tried.plan({}, plan::kBlockingShare)->trajectory->joints,
            whole.plan({})->trajectory->joints);
}

TEST_F(Rings, NothingToPrintGivesAFinding) {
  const plan::ToolPlan none;
  PartMotion moving(none, plate_, cell_, process::Tooling(process_), {}, {}, {});
  for (const auto& stage : {moving.plan({}), moving.planWithout({}, {})}) {
    EXPECT_EQ(stage->trajectory, nullptr);
    ASSERT_EQ(stage->findings.size(), 1u);
    EXPECT_EQ(stage->findings.front().kind, plan::FindingKind::NothingToPrint);
  }
}

} // namespace
} // namespace voluta::pipeline
