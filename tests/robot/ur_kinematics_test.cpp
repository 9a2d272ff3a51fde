// Check values, round trips and completeness of the UR family's closed-form inverse.
#include "joints_in_degrees.h"
#include "resource_fixture.h"

#include "base/units.h"
#include "robot/kinematics/ur_kinematics.h"
#include "robot/robot_model.h"

#include <gmock/gmock.h>
#include <random>

namespace voluta::robot {
namespace {

using base::kPi;
using test::joints;

// Standard DH, independent of the chain in the family's file.
Eigen::Isometry3d dhFlange(const UrGeometry& g, const JointVector& q) {
  const double a[6] = {0, g.a2, g.a3, 0, 0, 0}, d[6] = {g.d1, 0, 0, g.d4, g.d5, g.d6};
  const double alpha[6] = {kPi / 2, 0, 0, kPi / 2, -kPi / 2, 0};
  Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 6; ++i)
    t = t * Eigen::AngleAxisd(q[i], Eigen::Vector3d::UnitZ()) *
        Eigen::Translation3d(a[i], 0, d[i]) * Eigen::AngleAxisd(alpha[i], Eigen::Vector3d::UnitX());
  return t;
}

double angleBetweenFrames(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const Eigen::Matrix3d r = a.transpose() * b;
  return 0.5 * Eigen::Vector3d(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)).norm() +
         (r.trace() < 0 ? kPi : 0.0);
}

double jointDistance(const JointVector& a, const JointVector& b) {
  double worst = 0.0;
  for (int i = 0; i < 6; ++i)
    worst = std::max(worst, std::abs(std::remainder(a[i] - b[i], 2 * kPi)));
  return worst;
}

const UrGeometry kUr5{89.159, -425, -392.25, 109.15, 94.65, 82.3};

class Ur : public test::WithResources {};

TEST_F(Ur, checkValuesOfAllFour) {
  struct Row {
    const char* id;
    Eigen::Vector3d atZero, atBent;
  };
  const Row rows[] = {{"ur3", {-456.9, -194.25, 66.55}, {-298.6, -112.35, 313.65}},
                      {"ur5", {-817.25, -191.45, -5.491}, {-486.9, -109.15, 431.859}},
                      {"ur3e", {-456.75, -223.15, 66.5}, {-298.55, -131.05, 303.3}},
                      {"ur5e", {-817.2, -232.9, 62.8}, {-491.9, -133.3, 487.9}}};
  const double h = std::sqrt(0.5);
  for (const Row& row : rows) {
    const RobotModel robot = loadRobot(row.id);
    const Eigen::Isometry3d zero = robot.kinematics->flange(JointVector::Zero(6));
    const Eigen::Isometry3d bent = robot.kinematics->flange(joints({0, -90, 90, -90, -90, 0}));
    EXPECT_LT((zero.translation() - row.atZero).norm(), 1e-3) << row.id;
    EXPECT_LT((bent.translation() - row.atBent).norm(), 1e-3) << row.id;
    EXPECT_LT(angleBetweenFrames(zero.linear(), Eigen::Quaterniond(h, h, 0, 0).matrix()), 1e-12)
        << row.id;
    EXPECT_LT(angleBetweenFrames(bent.linear(), Eigen::Quaterniond(0, -h, -h, 0).matrix()), 1e-12)
        << row.id;
  }
}

TEST_F(Ur, flangeAgreesWithDenavitHartenbergAndWithTheLinks) {
  const UrKinematics kinematics(kUr5);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-2 * kPi, 2 * kPi);
  std::vector<Eigen::Isometry3d> links;
  for (int n = 0; n < 2000; ++n) {
    JointVector q(6);
    for (int i = 0; i < 6; ++i)
      q[i] = angle(random);
    const Eigen::Isometry3d dh = dhFlange(kUr5, q);
    kinematics.linkPoses(q, links);
    ASSERT_EQ(links.size(), 8u);
    EXPECT_TRUE(kinematics.flange(q).isApprox(dh, 1e-13));
    EXPECT_TRUE(links[7].isApprox(dh, 1e-13));
  }
}

TEST_F(Ur, inverseThenForwardOverRandomPoses) {
  for (const char* id : {"ur3", "ur5", "ur3e", "ur5e"}) {
    const RobotModel robot = loadRobot(id);
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> angle(-kPi, kPi);
    std::vector<JointVector> solutions;
    double worstMm = 0.0, worstRad = 0.0;
    std::size_t branches = 0, lost = 0;
    for (int n = 0; n < 100000; ++n) {
      JointVector q(6);
      for (int i = 0; i < 6; ++i)
        q[i] = angle(random);
      const Eigen::Isometry3d pose = robot.kinematics->flange(q);
      solutions.clear();
      robot.kinematics->inverse(pose, solutions);
      branches += solutions.size();
      double nearest = 10.0;
      for (const JointVector& s : solutions) {
        const Eigen::Isometry3d back = robot.kinematics->flange(s);
        worstMm = std::max(worstMm, (back.translation() - pose.translation()).norm());
        worstRad = std::max(worstRad, angleBetweenFrames(back.linear(), pose.linear()));
        nearest = std::min(nearest, jointDistance(s, q));
        ASSERT_TRUE(s.maxCoeff() <= kPi && s.minCoeff() > -kPi);
      }
      lost += nearest > 1e-5;
    }
    EXPECT_LE(worstMm, 1e-8) << id;
    EXPECT_LE(worstRad, 1e-9) << id;
    EXPECT_EQ(lost, 0u) << id;
    EXPECT_GT(branches, 400000u) << id;
    RecordProperty(std::string(id) + "_worstMm", std::to_string(worstMm * 1e12) + "e-12");
    RecordProperty(std::string(id) + "_worstRad", std::to_string(worstRad * 1e15) + "e-15");
  }
}

// Newton from a dense set of starts knows nothing of branches: all it finds must be there.
TEST_F(Ur, everyBranchADenseNumericSearchFinds) {
  const UrKinematics kinematics(kUr5);
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  const auto randomJoints = [&] {
    JointVector q(6);
    for (int i = 0; i < 6; ++i)
      q[i] = angle(random);
    return q;
  };
  std::size_t found = 0, poses = 0;
  for (int n = 0; n < 25; ++n) {
    const JointVector target = randomJoints();
    if (std::abs(std::sin(target[4])) < 0.1 || std::abs(std::sin(target[2])) < 0.1)
      continue; // branches that all but coincide are the next test's
    ++poses;
    const Eigen::Isometry3d pose = dhFlange(kUr5, target);
    std::vector<JointVector> closed, numeric;
    kinematics.inverse(pose, closed);
    const auto residual = [&](const JointVector& q) {
      const Eigen::Isometry3d t = dhFlange(kUr5, q);
      Eigen::Matrix<double, 12, 1> r;
      r.head<3>() = (t.translation() - pose.translation()) / 100.0;
      const Eigen::Matrix3d rotation = t.linear() - pose.linear();
      r.tail<9>() = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(rotation.data());
      return r;
    };
    for (int start = 0; start < 250; ++start) {
      JointVector q = randomJoints();
      auto r = residual(q);
      double damping = 1e-2;
      for (int step = 0; step < 60 && r.norm() > 1e-11; ++step) {
        Eigen::Matrix<double, 12, 6> jacobian;
        for (int i = 0; i < 6; ++i) {
          JointVector forward = q, backward = q;
          forward[i] += 1e-6;
          backward[i] -= 1e-6;
          jacobian.col(i) = (residual(forward) - residual(backward)) / 2e-6;
        }
        Eigen::Matrix<double, 6, 6> normal = jacobian.transpose() * jacobian;
        normal.diagonal().array() += damping;
        const JointVector next = q - normal.ldlt().solve(jacobian.transpose() * r);
        const auto tried = residual(next);
        damping *= tried.norm() < r.norm() ? 0.1 : 10.0;
        if (tried.norm() < r.norm()) {
          q = next;
          r = tried;
        }
      }
      if (r.norm() > 1e-9)
        continue;
      double known = 1e9, there = 1e9;
      for (const JointVector& s : numeric)
        known = std::min(known, jointDistance(s, q));
      if (known < 1e-4)
        continue;
      numeric.push_back(q);
      for (const JointVector& s : closed)
        there = std::min(there, jointDistance(s, q));
      EXPECT_LT(there, 1e-5);
    }
    EXPECT_EQ(numeric.size(), closed.size());
    found += numeric.size();
  }
  EXPECT_GT(found, 4 * poses);
}

TEST_F(Ur, singularPosesAreReachedOnceAWay) {
  const UrKinematics kinematics(kUr5);
  struct Row {
    const char* what;
    JointVector q;
  };
  // The shoulder's singular pose has the wrist centre right above or below the shoulder's offset:
  // a2 c2 + a3 c23 + d5 s234 = 0.
  JointVector shoulder = joints({20, 0, 100, 0, 70, 40});
  shoulder[1] = kPi / 2 - std::atan2(kUr5.a3 * std::sin(shoulder[2]),
                                     kUr5.a2 + kUr5.a3 * std::cos(shoulder[2]));
  shoulder[3] = -shoulder[1] - shoulder[2]; // s234 = 0
  const std::vector<Row> rows = {{"wrist", joints({20, -70, 80, 10, 0, 0})},
                                 {"wrist turned", joints({20, -70, 80, 10, 180, 0})},
                                 {"wrist, other theta6", joints({20, -70, 80, 10, 0, 55})},
                                 {"elbow", joints({20, -70, 0, 10, 60, 40})},
                                 {"shoulder", shoulder},
                                 {"all zero", joints({0, 0, 0, 0, 0, 0})},
                                 {"almost wrist", joints({20, -70, 80, 10, 1e-7, 33})},
                                 {"almost elbow", joints({20, -70, 1e-6, 10, 60, 40})}};
  for (const Row& row : rows) {
    const Eigen::Isometry3d pose = dhFlange(kUr5, row.q);
    std::vector<JointVector> solutions;
    kinematics.inverse(pose, solutions);
    ASSERT_FALSE(solutions.empty()) << row.what;
    for (std::size_t i = 0; i < solutions.size(); ++i) {
      const Eigen::Isometry3d back = dhFlange(kUr5, solutions[i]);
      EXPECT_LT((back.translation() - pose.translation()).norm(), 1e-8) << row.what;
      EXPECT_LT(angleBetweenFrames(back.linear(), pose.linear()), 1e-9) << row.what;
    }
  }
}

TEST_F(Ur, outOfReachGivesNothing) {
  const UrKinematics kinematics(kUr5);
  std::vector<JointVector> solutions;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(1100, 0, 0);
  kinematics.inverse(pose, solutions);
  EXPECT_TRUE(solutions.empty());
  pose.translation() = Eigen::Vector3d(20, 0, 400); // inside the shoulder's offset
  kinematics.inverse(pose, solutions);
  EXPECT_TRUE(solutions.empty());
}

TEST_F(Ur, inverseNearTurnsEachJointWithinItsLimits) {
  const RobotModel robot = loadRobot("ur5");
  const JointVector q = joints({300, -250, 100, 200, -190, 350});
  std::vector<JointVector> solutions(3, q); // its former contents are dropped
  inverseNear(robot, robot.kinematics->flange(q), q, solutions);
  ASSERT_LE(solutions.size(), 8u);
  double nearest = 1e9;
  for (const JointVector& s : solutions)
    nearest = std::min(nearest, (s - q).cwiseAbs().maxCoeff());
  EXPECT_LT(nearest, 1e-9);
  // Near a value beyond the limits the last turn inside is taken.
  const JointVector far = joints({500, -250, 100, 200, -190, 350});
  inverseNear(robot, robot.kinematics->flange(q), far, solutions);
  for (const JointVector& s : solutions)
    EXPECT_LE(s[0], 2 * kPi);
  // A joint stopped before pi has branches that cannot be turned inside: they are left out.
  RobotModel narrow = robot;
  narrow.limits[2].min = 0.0;
  inverseNear(narrow, robot.kinematics->flange(q), q, solutions);
  EXPECT_FALSE(solutions.empty());
  for (const JointVector& s : solutions)
    EXPECT_GE(s[2], 0.0);
}

} // namespace
} // namespace voluta::robot
