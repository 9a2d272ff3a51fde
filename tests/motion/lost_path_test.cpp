#include "base/run_context.h"
#include "collision/fill_times.h"
#include "collision/growing_part.h"
#include "motion/motion.h"
#include "motion/sample_plans.h"
#include "plan/finding_kinds.h"
#include "process/process.h"
#include "process/tooling.h"
#include "robot/cell.h"
#include "voxel/voxel_grid.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

namespace voluta {
namespace {

using Eigen::Vector3d;

// Three rings side by side on a plate, the middle one under a collar that the head's wide part
// neither passes from below nor from above.
class PathUnderACollar : public ::testing::Test {
protected:
  static constexpr double kRing = 3.0, kApart = 55.0;
  static constexpr double kHole = 8.5, kCollar = 25.0, kLow = 48.0;

  PathUnderACollar() {
    // Too wide for a collar's hole, then a neck that fits through it.
    process_.head.sections = {{0.0, 0.9},   {12.0, 6.0}, {12.0, 10.0},
                              {44.0, 10.0}, {44.0, 3.0}, {110.0, 3.0}};
    for (const double x : {-kApart, 0.0, kApart}) {
      std::vector<Vector3d> points, up;
      for (int i = 0; i <= 20; ++i) {
        const double a = base::kTwoPi * (i % 20) / 20;
        points.emplace_back(x + kRing * std::cos(a), kRing * std::sin(a), 0.8);
        up.push_back(Vector3d::UnitZ());
      }
      test::appendPath(plan_, points, up, 0, true);
    }
  }

  std::shared_ptr<const collision::FillTimes> collar() const {
    voxel::VoxelGrid grid;
    grid.pitch = 1.0;
    grid.size = {60, 60, 6};
    grid.origin = {-30.0, -30.0, kLow};
    collision::FillTimes::ReversedTimes leads(grid.cellCount());
    for (std::size_t c = 0; c < leads.size(); ++c) {
      const Eigen::Vector3i at = grid.cell(c);
      const double r = grid.centre(at.x(), at.y(), at.z()).head<2>().norm();
      if (r > kHole && r < kCollar)
        leads[c] = collision::FillTimes::leadOf(0);
    }
    return std::make_shared<const collision::FillTimes>(grid, std::move(leads), base::RunContext());
  }

  motion::MotionResult planned(std::shared_ptr<const collision::FillTimes> ground) const {
    const robot::Cell cell = robot::loadCell("ur5-fixed", process_, test::disc(80.0));
    const collision::GrowingPart part(plan_, 0.45, {}, std::move(ground));
    return motion::MotionPlanner(plan_, cell, process::Tooling(process_), part, {}).plan({});
  }

  plan::ToolPlan plan_;
  process::Process process_ = process::loadProcess("fdm-1.0");
};

TEST_F(PathUnderACollar, WithoutTheCollarAllIsPrinted) {
  EXPECT_TRUE(planned(nullptr).skipped.empty());
}

// No way leads to the middle ring: it is lost and named, and nothing else is.
TEST_F(PathUnderACollar, IsTheOnlyPathLost) {
  const motion::MotionResult moved = planned(collar());
  const plan::ToolPath& middle = plan_.paths[1];
  std::vector<std::size_t> ring;
  for (std::size_t w = middle.first; w < middle.first + middle.count; ++w)
    ring.push_back(w);
  EXPECT_EQ(moved.skipped, ring);

  const auto lost =
      std::ranges::find(moved.findings, plan::FindingKind::NoPathTo, &plan::Finding::kind);
  ASSERT_NE(lost, moved.findings.end());
  EXPECT_TRUE(lost->blocking);
  EXPECT_EQ(lost->count, middle.count);
  ASSERT_TRUE(lost->where);
  EXPECT_LT((*lost->where - plan_.position[middle.first]).norm(), 1e-9);

  // The trajectory is sound: it starts and ends at rest in the home pose.
  const plan::Trajectory& t = moved.trajectory;
  ASSERT_GT(t.pointCount(), 2u);
  EXPECT_EQ(moved.statistics.waypoints, plan_.waypointCount() - middle.count);
  EXPECT_EQ(std::ranges::count_if(moved.findings,
                                  [](const plan::Finding& f) {
                                    return f.kind == plan::FindingKind::CollisionInMotion;
                                  }),
            0);
}

// A head so wide that it meets the arm at rest: one finding names it at once, and nothing is tried.
TEST_F(PathUnderACollar, CollisionInTheHomePoseIsFoundFirst) {
  process_.head.sections = {{0.0, 0.9}, {12.0, 6.0}, {12.0, 700.0}, {110.0, 700.0}};
  const motion::MotionResult moved = planned(nullptr);
  ASSERT_FALSE(moved.findings.empty());
  EXPECT_EQ(moved.findings.front().kind, plan::FindingKind::HomeMeets);
  EXPECT_TRUE(moved.findings.front().blocking);
  EXPECT_EQ(moved.skipped.size(), plan_.waypointCount());
}

} // namespace
} // namespace voluta
