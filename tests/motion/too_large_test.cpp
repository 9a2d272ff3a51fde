// A part that is too large for its robot: how much of it is out of reach, and the size at which it
// is not.
#include "base/run_context.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "motion/motion.h"
#include "motion/sample_plans.h"
#include "process/process.h"
#include "process/tooling.h"
#include "robot/cell.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace voluta;
using Eigen::Vector3d;

namespace {

// An upright ring of points 3 degrees apart over the middle of the plate.
motion::MotionResult ringOf(const char* cellId, double radius, double height,
                            const Vector3d& direction = Vector3d::UnitZ()) {
  std::vector<Vector3d> points;
  for (int k = 0; k < 120; ++k) {
    const double a = base::degreesToRadians(3.0 * k);
    points.emplace_back(radius * std::cos(a), radius * std::sin(a), height);
  }
  plan::ToolPlan plan;
  test::appendPath(plan, points, std::vector<Vector3d>(points.size(), direction), 0);
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell(cellId, process, test::disc(20));
  const collision::GrowingPart part(plan, 4.0, {});
  return motion::MotionPlanner(plan, cell, process::Tooling(process), part, {}).plan({});
}

} // namespace

TEST(TooLarge, PartWithinReachIsNotTooLarge) {
  EXPECT_FALSE(ringOf("ur5-fixed", 30.0, 20.0).tooLarge);
  EXPECT_FALSE(ringOf("kr6-r900-moving", 60.0, 20.0).tooLarge);
}

TEST(TooLarge, PartScaledToTheNamedSizeIsWithinReach) {
  for (const char* cell : {"kr6-r900-moving", "ur5-moving"})
    for (const auto& [radius, height] : {std::pair(150.0, 1200.0), std::pair(700.0, 80.0)}) {
      const motion::MotionResult whole = ringOf(cell, radius, height);
      ASSERT_TRUE(whole.tooLarge) << cell << " " << radius;
      EXPECT_NEAR(whole.tooLarge->share, whole.statistics.unreachable / 120.0, 0.02);
      EXPECT_GT(whole.tooLarge->share, motion::kTooLargeShare);
      ASSERT_TRUE(whole.tooLarge->size) << cell << " " << radius;
      const double size = *whole.tooLarge->size;
      EXPECT_LT(size, 1.0);
      EXPECT_LE(ringOf(cell, size * radius, size * height).statistics.unreachable, 2u)
          << cell << " " << radius;
      const double more = size + 0.1;
      EXPECT_GT(ringOf(cell, more * radius, more * height).statistics.unreachable, 0u)
          << cell << " " << radius;
    }
}

// The nozzle would come from below the plate at any size.
TEST(TooLarge, NoSizeIsNamedWhereNoneHelps) {
  const motion::MotionResult result =
      ringOf("kr6-r900-moving", 15.0, 2.0, Vector3d(0.0, 0.0, -1.0));
  if (result.tooLarge) {
    EXPECT_FALSE(result.tooLarge->size);
  }
  const motion::MotionResult far = ringOf("kr6-r900-moving", 15000.0, 2.0);
  ASSERT_TRUE(far.tooLarge);
  EXPECT_EQ(far.tooLarge->share, 1.0);
  EXPECT_FALSE(far.tooLarge->size);
}
