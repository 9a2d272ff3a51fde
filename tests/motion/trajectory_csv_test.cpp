#include "motion/trajectory_csv.h"

#include <gtest/gtest.h>

using namespace voluta;

TEST(TrajectoryCsv, Golden) {
  plan::Trajectory t;
  t.dof = 2;
  t.joints = {0.0, 3.14159265358979312, 1.57079632679489656, 0.0};
  t.timeS = {0.0, 1.25};
  t.move = {plan::MoveKind::Joint, plan::MoveKind::Print};
  t.waypoint = {plan::kNoWaypoint, 7};
  t.extrudedMm3 = {0.0, 2.5};
  EXPECT_EQ(motion::trajectoryCsv(t, {}, 2.0),
            "timeS,q1Deg,q2Deg,extrudedMm3,extrudedMm,waypoint,move\n"
            "0.000000,0.0000000,180.0000000,0.00000,0.00000,-1,joint\n"
            "1.250000,90.0000000,0.0000000,2.50000,0.79577,7,print\n");
  t.joints = {0.0, -12.5, 1.57079632679489656, 0.0};
  EXPECT_EQ(motion::trajectoryCsv(t, {robot::JointKind::Turning, robot::JointKind::Sliding}, 2.0),
            "timeS,q1Deg,q2Mm,extrudedMm3,extrudedMm,waypoint,move\n"
            "0.000000,0.0000000,-12.5000000,0.00000,0.00000,-1,joint\n"
            "1.250000,90.0000000,0.0000000,2.50000,0.79577,7,print\n");
}
