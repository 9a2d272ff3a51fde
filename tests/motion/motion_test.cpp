#include "motion/motion.h"

#include "base/run_context.h"
#include "base/stopwatch.h"
#include "motion/sample_plans.h"

#include <gtest/gtest.h>
#include <iostream>

using namespace voluta;

namespace {

struct Planned {
  plan::ToolPlan plan;
  process::Process process = process::loadProcess("fdm-1.0");
  robot::Cell cell;
  collision::GrowingPart part;
  motion::MotionResult result;

  explicit Planned(plan::ToolPlan p, double plateRadius = 20.0, int threads = 2)
      : plan(std::move(p)), cell(robot::loadCell("ur5-fixed", process, test::disc(plateRadius))),
        part(plan, 0.45, {}),
        result(motion::planMotion(plan, cell, process, part, {},
                                  base::RunContext(base::CancelToken(), threads))) {}

  void print(const char* name) const {
    const auto& s = result.statistics;
    const auto& t = result.times;
    std::cout << name << ": " << plan.waypointCount() << " waypoints, " << plan.paths.size()
              << " paths; printed " << s.waypoints << ", unreachable " << s.unreachable
              << ", collisions " << s.collisions << ", splits " << s.splits << ", transfers "
              << s.transfers << " (arc " << s.arcTransfers << ", joint " << s.jointTransfers
              << ", tree " << s.treeTransfers << "), clearance " << s.minClearanceMm
              << " mm, points " << result.trajectory.pointCount() << ", duration " << s.durationS
              << " s, jerk " << s.sumSquaredJerkBefore << " -> " << s.sumSquaredJerk
              << "\n  times ik " << t.ik << ", graph " << t.graph << ", collision " << t.collision
              << ", transfer " << t.transfer << ", jerk " << t.jerk << "\n";
    for (const auto& f : result.findings)
      std::cout << "  " << f.kind << " x" << f.count << ": " << f.reason << "\n";
  }
};

} // namespace

TEST(Motion, Cylinder) {
  const Planned p(test::cylinder(15, 25));
  p.print("cylinder");
  EXPECT_TRUE(p.result.findings.empty());
}
TEST(Motion, Slab) {
  const Planned p(test::slab(30, 6), 22);
  p.print("slab");
  EXPECT_TRUE(p.result.findings.empty());
}
TEST(Motion, Hemisphere) {
  const Planned p(test::hemisphere(25, 35, 1.6, 0.3), 12);
  p.print("hemisphere");
  EXPECT_TRUE(p.result.findings.empty());
}
