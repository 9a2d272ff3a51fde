// Layout of the cell "lathe": all of its rod can be printed on, for any thickness of the part.
#include "base/units.h"
#include "collision/cell_collision.h"
#include "platform/platform_solid.h"
#include "platform/rod_shape.h"
#include "process/process.h"
#include "robot/cell.h"
#include "robot/robot_model.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace voluta;
using Eigen::Vector3d;

namespace {

// The cell with a rod as thick as a part is by then.
struct Rod {
  process::Process process = process::loadProcess("fdm-0.35");
  robot::Cell cell;
  collision::CellCollision collision;
  double radius;

  explicit Rod(double r) : cell(cellOf(process, r)), collision(cell, process), radius(r) {}
  static robot::Cell cellOf(const process::Process& process, double r) {
    platform::PlatformSolid rod;
    rod.rod = platform::straightRod(2 * r, 200);
    return robot::loadCell("lathe", process, rod);
  }

  // The greatest clearance of the poses that deposit a bead at x with the nozzle turned from
  // straight down about the rod; 0 where none of them keeps 2 mm.
  double clearance(double x, double angle) const {
    double best = 0.0;
    for (int k = 0; k < 24; ++k) {
      // With the rod at 0 the work frame's z is up.
      Eigen::Isometry3d work_T_tool = Eigen::Isometry3d::Identity();
      work_T_tool.linear() =
          Vector3d(1, -1, -1).asDiagonal() *
          Eigen::AngleAxisd(k * base::kPi / 12, Vector3d::UnitZ()).toRotationMatrix();
      work_T_tool.translation() = Vector3d(x, 0, radius + 0.25);
      robot::JointVector near = cell.home();
      near[6] = angle;
      std::vector<robot::JointVector> solutions;
      cell.inverse(work_T_tool, near, solutions);
      for (const robot::JointVector& q : solutions) {
        collision::CellCollision::Frames frames;
        cell.framePoses(q, frames);
        if (!collision.bodies(frames, {2.0, 2.0, -0.1}))
          best = std::max(best, collision.clearance(frames, 50.0));
      }
    }
    return best;
  }
};

} // namespace

TEST(LatheCell, HomeIsClearOfTheThickestPart) {
  const Rod rod(50);
  collision::CellCollision::Frames frames;
  rod.cell.framePoses(rod.cell.home(), frames);
  EXPECT_FALSE(rod.collision.bodies(frames, {10.0, 10.0, 50.0}));
  EXPECT_GT(rod.collision.clearance(frames, 50.0), 10.0);
}

TEST(LatheCell, AllOfTheRodIsPrintedOnWithTheNozzleDown) {
  for (const double radius : {2.5, 10.0, 25.0, 50.0}) {
    const Rod rod(radius);
    for (double x = -100; x <= 100; x += 5) {
      EXPECT_GT(rod.clearance(x, 0.0), std::abs(x) < 85 ? 10.0 : 2.0) << radius << ", " << x;
      for (const double angle : {-15.0, 15.0})
        EXPECT_GT(rod.clearance(x, base::degreesToRadians(angle)), 2.0) << radius << ", " << x;
    }
  }
}

// By the layout of the cell the wrist is not stretched, where joints 4 and 6 would spin.
TEST(LatheCell, WristIsBentInAllPrintingPoses) {
  const Rod rod(25);
  for (const double angle : {-30.0, 0.0, 30.0})
    for (double x = -100; x <= 100; x += 10)
      for (const double r : {2.5, 50.0}) {
        Eigen::Isometry3d work_T_tool = Eigen::Isometry3d::Identity();
        work_T_tool.linear() = Vector3d(1, -1, -1).asDiagonal();
        work_T_tool.translation() = Vector3d(x, 0, r);
        robot::JointVector near = rod.cell.home();
        near[6] = base::degreesToRadians(angle);
        std::vector<robot::JointVector> solutions;
        rod.cell.inverse(work_T_tool, near, solutions);
        ASSERT_FALSE(solutions.empty()) << x << ", " << r << ", " << angle;
        for (const robot::JointVector& q : solutions)
          EXPECT_GT(std::abs(q[4]), base::degreesToRadians(20)) << x << ", " << r << ", " << angle;
      }
}
