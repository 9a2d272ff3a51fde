// Clearance is sought: of ways that print the same, one along which everything stays further apart.
#include "base/run_context.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "motion/sample_plans.h"
#include "process/process.h"
#include "process/tooling.h"
#include "robot/cell.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace voluta;

namespace {

struct Clearances {
  std::size_t points = 0, near = 0; // printed; nearer than enough
  double lack = 0.0;                // mm of enough, all together
  motion::MotionResult result;
};

Clearances planned(const char* cellId, const plan::ToolPlan& plan, double plateMm, double nearCost,
                   int threads = 2) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell(cellId, process, test::disc(plateMm));
  const collision::GrowingPart part(plan, 0.45, {});
  motion::MotionOptions options;
  options.nearCost = nearCost;
  Clearances c;
  c.result = motion::MotionPlanner(plan, cell, process::Tooling(process), part, options)
                 .plan(base::RunContext(base::CancelToken(), threads));
  // By the queries themselves, at every waypoint.
  const collision::CellCollision collision(cell, process);
  const plan::Trajectory& t = c.result.trajectory;
  collision::CellCollision::Frames frames;
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    if (t.move[i] != plan::MoveKind::Print || t.waypoint[i] == plan::kNoWaypoint)
      continue;
    cell.framePoses(Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof), frames);
    const double clear = collision.clearanceToPart(frames, part, t.waypoint[i],
                                                   collision.clearance(frames, options.enoughMm));
    ++c.points;
    c.near += clear < options.enoughMm;
    c.lack += options.enoughMm - clear;
  }
  return c;
}

} // namespace

// A low dome, so that the arm reaches about its plate and the nozzle's holder.
TEST(Clearance, IsSoughtWhereThereIsRoom) {
  const plan::ToolPlan dome = test::hemisphere(20.0, 0.5, 1.4, 0.3);
  for (const char* cell : {"ur5-fixed", "ur3-fixed"}) {
    const Clearances kept = planned(cell, dome, 60.0, 0.0), sought = planned(cell, dome, 60.0, 1.0);
    ASSERT_GT(kept.near, 50u) << cell; // else there is nothing to gain
    EXPECT_LT(sought.near, kept.near / 2) << cell;
    EXPECT_LT(sought.lack, 0.5 * kept.lack) << cell;
    EXPECT_EQ(sought.points, kept.points);
    // The head has no room at the dome's foot in any pose of the arm.
    EXPECT_EQ(sought.result.skipped, kept.result.skipped);
    EXPECT_EQ(sought.result.statistics.collisions, kept.result.statistics.collisions);
  }
}

TEST(Clearance, ChangesNothingWhereAllIsClear) {
  const plan::ToolPlan plan = test::slab(30.0, 1);
  const Clearances kept = planned("ur5-fixed", plan, 60.0, 0.0),
                   sought = planned("ur5-fixed", plan, 60.0, 1.0);
  ASSERT_EQ(kept.near, 0u);
  EXPECT_EQ(sought.result.trajectory.joints, kept.result.trajectory.joints);
}

TEST(Clearance, IsTheSameForAnyThreads) {
  const plan::ToolPlan dome = test::hemisphere(15.0, 5.0, 1.57, 0.5);
  EXPECT_EQ(planned("ur5-fixed", dome, 60.0, 1.0, 1).result.trajectory.joints,
            planned("ur5-fixed", dome, 60.0, 1.0, 3).result.trajectory.joints);
}
