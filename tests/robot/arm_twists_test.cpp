// The flange's motion with the joints, of every robot that is shipped: against differences of the
// forward kinematics, and followed to poses near by.
#include "resource_fixture.h"

#include "robot/kinematics/arm_twists.h"

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <random>

namespace voluta::robot {
namespace {

class EveryArm : public test::WithResources {
protected:
  // Away from limits, by so much of the range.
  static JointVector randomJoints(const RobotModel& robot, std::mt19937& random) {
    JointVector q(robot.dof());
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const JointLimits& l = robot.limits[static_cast<std::size_t>(j)];
      q[j] = std::uniform_real_distribution<double>(0.9 * l.min + 0.1 * l.max,
                                                    0.1 * l.min + 0.9 * l.max)(random);
    }
    return q;
  }
};

TEST_F(EveryArm, JacobianIsTheDerivativeOfTheFlange) {
  std::mt19937 random(3);
  std::vector<Eigen::Isometry3d> links;
  for (const std::string& id : robotIds()) {
    const RobotModel robot = loadRobot(id);
    const ArmTwists twists(*robot.kinematics);
    for (int n = 0; n < 50; ++n) {
      const JointVector q = randomJoints(robot, random);
      Eigen::Isometry3d flange;
      const ArmJacobian jacobian = twists.jacobian(q, flange, links);
      EXPECT_LT((flange.matrix() - robot.kinematics->flange(q).matrix()).norm(), 1e-9);
      for (Eigen::Index j = 0; j < q.size(); ++j) {
        constexpr double kStep = 1e-5;
        JointVector more = q, less = q;
        more[j] += kStep;
        less[j] -= kStep;
        const Eigen::Isometry3d a = robot.kinematics->flange(less),
                                b = robot.kinematics->flange(more);
        const Eigen::Vector3d velocity = (b.translation() - a.translation()) / (2.0 * kStep);
        const Eigen::AngleAxisd rotation(b.linear() * a.linear().transpose());
        const Eigen::Vector3d spin = rotation.angle() * rotation.axis() / (2.0 * kStep);
        EXPECT_LT((jacobian.col(j).head<3>() - velocity).norm(), 1e-3) << id << " joint " << j;
        EXPECT_LT((jacobian.col(j).tail<3>() - spin).norm(), 1e-5) << id << " joint " << j;
      }
    }
  }
}

TEST_F(EveryArm, FollowsToPosesNearBy) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> step(-0.03, 0.03);
  std::vector<Eigen::Isometry3d> links;
  for (const std::string& id : robotIds()) {
    const RobotModel robot = loadRobot(id);
    const ArmTwists twists(*robot.kinematics);
    int there = 0;
    for (int n = 0; n < 100; ++n) {
      const JointVector q = randomJoints(robot, random);
      JointVector near = q;
      for (Eigen::Index j = 0; j < q.size(); ++j)
        near[j] += fromAngle(robot.kinematics->kindOf(static_cast<int>(j)), step(random));
      ArmJacobian jacobian;
      const Eigen::Isometry3d wanted = robot.kinematics->flange(q);
      if (!twists.follow(wanted, 0.5, near, jacobian, links))
        continue; // a singular pose is near
      ++there;
      const Eigen::Isometry3d is = robot.kinematics->flange(near);
      EXPECT_LT((is.translation() - wanted.translation()).norm(), 1e-7) << id;
      EXPECT_LT((is.linear() - wanted.linear()).norm(), 1e-9) << id;
    }
    EXPECT_GE(there, 90) << id;
  }
}

// A pose's two ways to hold a wrist are on either side of the straight one, which is on neither.
TEST_F(EveryArm, AWristThatTurnsOverChangesSides) {
  std::mt19937 random(5);
  std::vector<Eigen::Isometry3d> links;
  for (const char* id :
       {"ur3e", "ur5", "ur10", "tm5-700", "irb1200", "irb2400", "kr6-r900", "rv2f"}) {
    const RobotModel robot = loadRobot(id);
    const ArmTwists twists(*robot.kinematics);
    for (int n = 0; n < 50; ++n) {
      JointVector q = randomJoints(robot, random);
      const int side = twists.singularSide(q, links);
      EXPECT_NE(side, 0) << id;
      q[4] = -q[4];
      EXPECT_EQ(twists.singularSide(q, links), -side) << id;
      q[4] = 0.0;
      EXPECT_EQ(twists.singularSide(q, links), 0) << id;
    }
  }
}

// Along a straight way of the joints the side changes where the determinant of differences of the
// forward kinematics does; a SCARA has none.
TEST_F(EveryArm, SidesAreThoseOfTheDeterminant) {
  std::mt19937 random(6);
  std::vector<Eigen::Isometry3d> links;
  for (const std::string& id : robotIds()) {
    const RobotModel robot = loadRobot(id);
    const ArmTwists twists(*robot.kinematics);
    for (int n = 0; n < 50; ++n) {
      const JointVector q = randomJoints(robot, random);
      if (robot.dof() != 6) {
        EXPECT_EQ(twists.singularSide(q, links), 0) << id;
        continue;
      }
      Eigen::Matrix<double, 6, 6> change;
      for (Eigen::Index j = 0; j < 6; ++j) {
        constexpr double kStep = 1e-5;
        JointVector more = q, less = q;
        more[j] += kStep;
        less[j] -= kStep;
        const Eigen::Isometry3d a = robot.kinematics->flange(less),
                                b = robot.kinematics->flange(more);
        const Eigen::AngleAxisd rotation(b.linear() * a.linear().transpose());
        change.col(j) << (b.translation() - a.translation()) / 1000.0,
            rotation.angle() * rotation.axis();
      }
      const double determinant = (change / 2e-5).determinant();
      if (std::abs(determinant) > 1e-4) {
        EXPECT_EQ(twists.singularSide(q, links), determinant > 0.0 ? 1 : -1) << id;
      }
    }
  }
}

TEST_F(EveryArm, PoseOutOfReachIsNotFollowed) {
  const RobotModel robot = loadRobot("ur5");
  const ArmTwists twists(*robot.kinematics);
  JointVector q = JointVector::Constant(6, 0.5);
  Eigen::Isometry3d far = robot.kinematics->flange(q);
  far.translation() *= 10.0;
  ArmJacobian jacobian;
  std::vector<Eigen::Isometry3d> links;
  EXPECT_FALSE(twists.follow(far, 0.5, q, jacobian, links));
}

} // namespace
} // namespace voluta::robot
