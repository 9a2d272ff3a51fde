// Every robot that comes with the program: joints and poses there and back, and the flange where
// the makers' descriptions have it, by chains of turns that share nothing with the families.
#include "joints_in_degrees.h"
#include "resource_fixture.h"

#include "base/units.h"
#include "robot/robot_model.h"

#include <array>
#include <functional>
#include <gmock/gmock.h>
#include <random>
#include <tuple>

namespace voluta::robot {
namespace {

using base::degreesToRadians;
using base::kPi;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using test::joints;

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

double angleBetweenFrames(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return (a - b).norm() / std::sqrt(2.0);
}

// Fixed offsets between turns about single axes, as an URDF has them, and the flange's own turn.
struct Joint {
  Vector3d origin, axis;
};
Isometry3d chainFlange(const std::array<Joint, 6>& chain, const Isometry3d& last,
                       const JointVector& q) {
  Isometry3d t = Isometry3d::Identity();
  for (std::size_t i = 0; i < 6; ++i)
    t = t * Eigen::Translation3d(chain[i].origin) *
        Eigen::AngleAxisd(q[static_cast<Eigen::Index>(i)], chain[i].axis);
  return t * last;
}

Isometry3d asIsometry(const Eigen::AngleAxisd& rotation) {
  return Isometry3d(rotation);
}

class Robots : public test::WithResources {
protected:
  JointVector randomJoints(const RobotModel& robot) {
    JointVector q(robot.dof());
    for (int i = 0; i < robot.dof(); ++i) {
      const JointLimits& limit = robot.limits[static_cast<std::size_t>(i)];
      q[i] = std::uniform_real_distribution<double>(limit.min, limit.max)(random_);
    }
    return q;
  }
  void expectChain(const std::string& id, const std::array<Joint, 6>& chain, const Isometry3d& last,
                   const std::function<JointVector(const JointVector&)>& ofChain) {
    const RobotModel robot = loadRobot(id);
    for (int n = 0; n < 200; ++n) {
      const JointVector q = randomJoints(robot);
      const Isometry3d there = chainFlange(chain, last, ofChain(q));
      const Isometry3d here = robot.kinematics->flange(q);
      ASSERT_LT((here.translation() - there.translation()).norm(), 1e-6) << id;
      ASSERT_LT(angleBetweenFrames(here.linear(), there.linear()), 1e-9) << id;
    }
  }

  std::mt19937_64 random_{19};
};

TEST_F(Robots, InverseFindsTheJointsOfEachForwardPose) {
  for (const std::string& id : robotIds()) {
    const RobotModel robot = loadRobot(id);
    std::vector<JointVector> solutions;
    std::vector<Isometry3d> links;
    for (int n = 0; n < 2000; ++n) {
      const JointVector q = randomJoints(robot);
      const Isometry3d flange = robot.kinematics->flange(q);
      robot.kinematics->linkPoses(q, links);
      ASSERT_TRUE(links.back().isApprox(flange, 1e-10)) << id;
      inverseNear(robot, flange, q, solutions);
      double nearest = 1e9;
      for (const JointVector& s : solutions) {
        const Isometry3d back = robot.kinematics->flange(s);
        ASSERT_LT((back.translation() - flange.translation()).norm(), 1e-6) << id;
        ASSERT_LT(angleBetweenFrames(back.linear(), flange.linear()), 1e-8) << id;
        nearest = std::min(nearest, (s - q).cwiseAbs().maxCoeff());
      }
      ASSERT_LT(nearest, 1e-5) << id << " at " << q.transpose();
    }
  }
}

// Lengths alone: axes and zeros where every arm of the maker has them.
TEST_F(Robots, UniversalRobotsAreStretchedAtZero) {
  struct Row {
    const char* id;
    double d1, a2, a3, d4, d5, d6;
  };
  const Row rows[] = {{"ur10", 127.3, -612, -572.3, 163.941, 115.7, 92.2},
                      {"ur10e", 180.7, -612.7, -571.55, 174.15, 119.85, 116.55}};
  for (const Row& r : rows) {
    const Isometry3d zero = loadRobot(r.id).kinematics->flange(JointVector::Zero(6));
    EXPECT_LT((zero.translation() - Vector3d(r.a2 + r.a3, -r.d4 - r.d6, r.d1 - r.d5)).norm(), 1e-9)
        << r.id;
  }
}

TEST_F(Robots, TechmanAsItsDescriptionHasIt) {
  const double h = std::sqrt(0.5);
  const RobotModel tm = loadRobot("tm5-700");
  const Isometry3d zero = tm.kinematics->flange(JointVector::Zero(6));
  EXPECT_LT((zero.translation() - Vector3d(0, -235.45, 891.7)).norm(), 1e-3);
  EXPECT_LT(angleBetweenFrames(zero.linear(), Eigen::Quaterniond(h, h, 0, 0).matrix()), 1e-9);
  const Isometry3d bent = tm.kinematics->flange(joints({0, 0, 90, 0, 90, 0}));
  EXPECT_LT((bent.translation() - Vector3d(417.5, -122.3, 361.05)).norm(), 1e-3);
  EXPECT_LT(angleBetweenFrames(bent.linear(), Eigen::Quaterniond(0, -h, -h, 0).matrix()), 1e-9);
  // Denavit and Hartenberg's four numbers a joint.
  const double a[6] = {0, 329, 311.5, 0, 0, 0}, d[6] = {145.2, 0, 0, -122.3, 106, 113.15},
               alpha[6] = {-90, 0, 0, 90, 90, 0}, offset[6] = {0, -90, 0, 90, 0, 0};
  for (int n = 0; n < 200; ++n) {
    const JointVector q = randomJoints(tm);
    Isometry3d t = Isometry3d::Identity();
    for (int i = 0; i < 6; ++i)
      t = t * Eigen::AngleAxisd(q[i] + degreesToRadians(offset[i]), kZ) *
          Eigen::Translation3d(a[i], 0, d[i]) * Eigen::AngleAxisd(degreesToRadians(alpha[i]), kX);
    const Isometry3d here = tm.kinematics->flange(q);
    ASSERT_LT((here.translation() - t.translation()).norm(), 1e-6);
    ASSERT_LT(angleBetweenFrames(here.linear(), t.linear()), 1e-9);
  }
}

TEST_F(Robots, MitsubishiAsItsDescriptionHasIt) {
  expectChain("rv2f",
              {{{{0, 0, 0}, kZ},
                {{0, 0, 295}, kY},
                {{0, 0, 230}, kY},
                {{-50, 0, 0}, kZ},
                {{0, 0, 270}, kY},
                {{0, 0, 70}, kZ}}},
              Isometry3d::Identity(), [](const JointVector& q) { return q; });
}

// The parallelogram holds the forearm where it is when axis 2 turns.
TEST_F(Robots, Irb2400TellsItsThirdAxisFromTheBase) {
  expectChain("irb2400",
              {{{{0, 0, 0}, kZ},
                {{100, 0, 615}, kY},
                {{0, 0, 705}, kY},
                {{0, 0, 135}, kX},
                {{755, 0, 0}, kY},
                {{0, 0, 0}, kX}}},
              Eigen::Translation3d(85, 0, 0) * asIsometry(Eigen::AngleAxisd(kPi / 2, kY)),
              [](JointVector q) {
                q[2] -= q[1];
                return q;
              });
  const RobotModel robot = loadRobot("irb2400");
  const auto forearm = [&](double second) {
    std::vector<Isometry3d> links;
    robot.kinematics->linkPoses(joints({0, second, 10, 0, 0, 0}), links);
    return Eigen::Matrix3d(links[3].linear());
  };
  EXPECT_LT(angleBetweenFrames(forearm(-20), forearm(40)), 1e-12);
}

TEST_F(Robots, KukaTurnsThreeAxesTheOtherWay) {
  for (const auto& [id, upper, fore] :
       {std::tuple{"kr6-r900", 455.0, 420.0}, std::tuple{"kr10-r1100", 560.0, 515.0}})
    expectChain(id,
                {{{{0, 0, 400}, -kZ},
                  {{25, 0, 0}, kY},
                  {{upper, 0, 0}, kY},
                  {{0, 0, 35}, -kX},
                  {{fore, 0, 0}, kY},
                  {{80, 0, 0}, -kX}}},
                asIsometry(Eigen::AngleAxisd(kPi / 2, kY)), [](const JointVector& q) { return q; });
}

} // namespace
} // namespace voluta::robot
