// The clearance returned for bodies that come close and do not touch.
#include "collision/growing_part.h"
#include "collision/way_clearance.h"
#include "plan/tool_plan.h"
#include "robot/cell.h"

#include "base/run_context.h"
#include "process/process.h"

#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using robot::JointVector;

// The way's bound of the least distance falls below 0 where bodies are nearer than it is exact.
TEST(MinClearance, IsNotBelowZeroWhereNothingTouches) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell =
      robot::loadCell("ur5-moving", process, {{-60, -60}, {60, -60}, {60, 60}, {-60, 60}});
  const collision::CellCollision collision(cell, process);
  const collision::GrowingPart part(plan::ToolPlan{}, 0.45, {});
  const collision::MotionClearance ways(collision, part);
  const auto at = [&](const JointVector& q) {
    collision::CellCollision::Frames frames;
    cell.framePoses(q, frames);
    return collision.clearance(frames, 200.0);
  };
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  int near = 0;
  for (int n = 0; n < 400 && near < 40; ++n) {
    JointVector clear = cell.home(), met = cell.home();
    for (Eigen::Index j = 0; j < cell.armDof(); ++j) {
      clear[j] += 0.5 * share(engine);
      met[j] += 2.5 * share(engine);
    }
    if (at(clear) <= 1.0 || at(met) > 0.0)
      continue;
    // The last pose before it touches, as near as 0.02 mm.
    JointVector from = clear;
    for (int k = 0; k < 60 && at(clear) > 0.02; ++k) {
      const JointVector middle = 0.5 * (clear + met);
      (at(middle) > 0.0 ? clear : met) = middle;
    }
    if (at(clear) > 0.02)
      continue;
    ++near;
    from = clear + 0.1 * (from - clear);
    EXPECT_GE(ways.along(from, clear, 0, at(from)), 0.0);
    EXPECT_LE(ways.along(from, clear, 0, at(from)), at(clear));
  }
  EXPECT_GE(near, 10);
}
