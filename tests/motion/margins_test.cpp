// Margins against Jacobians of the published link lengths, by hand.
#include "motion/joint_margins.h"

#include "base/run_context.h"
#include "base/units.h"
#include "motion/sample_plans.h"
#include "process/process.h"

#include <Eigen/SVD>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace voluta;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

double ratioOf(const Jacobian& jacobian) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd{Eigen::MatrixXd(jacobian)};
  return svd.singularValues()[svd.singularValues().size() - 1] / svd.singularValues()[0];
}

constexpr double kUr5Reach = 89.159 + 425.0 + 94.65 + 82.3; // and the forearm, which is offset
double ur5Reach() {
  return kUr5Reach + std::hypot(392.25, 109.15);
}

// The UR5 as its maker's Denavit-Hartenberg parameters have it.
Jacobian ur5Jacobian(const JointVector& q) {
  constexpr double kQuarter = 0.5 * base::kPi;
  const double a[] = {0, -425, -392.25, 0, 0, 0}, d[] = {89.159, 0, 0, 109.15, 94.65, 82.3},
               alpha[] = {kQuarter, 0, 0, kQuarter, -kQuarter, 0};
  Isometry3d frame = Isometry3d::Identity();
  Vector3d axis[6], origin[6];
  for (int j = 0; j < 6; ++j) {
    axis[j] = frame.linear().col(2);
    origin[j] = frame.translation();
    frame = frame * Eigen::AngleAxisd(q[j], Vector3d::UnitZ()) *
            Eigen::Translation3d(a[j], 0, d[j]) * Eigen::AngleAxisd(alpha[j], Vector3d::UnitX());
  }
  Jacobian jacobian(6, 6);
  for (int j = 0; j < 6; ++j)
    jacobian.col(j) << axis[j].cross(frame.translation() - origin[j]) / ur5Reach(), axis[j];
  return jacobian;
}

JointVector anyWithin(const std::vector<robot::JointLimits>& limits, std::mt19937& random) {
  JointVector q(static_cast<Eigen::Index>(limits.size()));
  for (std::size_t j = 0; j < limits.size(); ++j)
    q[static_cast<Eigen::Index>(j)] =
        std::uniform_real_distribution<double>(limits[j].min, limits[j].max)(random);
  return q;
}

} // namespace

TEST(Margins, IsotropyIsTheRatioOfTheJacobiansSingularValues) {
  const robot::RobotModel ur5 = robot::loadRobot("ur5");
  EXPECT_NEAR(motion::reachOf(ur5), ur5Reach(), 1e-9);
  std::mt19937 random(31);
  double maximum = 0.0;
  for (int round = 0; round < 300; ++round) {
    const JointVector q = anyWithin(ur5.limits, random);
    const double isotropy = motion::isotropyAt(ur5, q, ur5Reach());
    EXPECT_NEAR(isotropy, ratioOf(ur5Jacobian(q)), 1e-6);
    maximum = std::max(maximum, isotropy);
  }
  EXPECT_GT(maximum, 0.05);
}

// Four axes, the third of which slides: a mm counts by the reach, as a turn's lengths do.
TEST(Margins, IsotropyOfAnArmThatSlides) {
  const robot::RobotModel t3 = robot::loadRobot("t3-401s");
  EXPECT_NEAR(motion::reachOf(t3), 225.0 + 175.0, 1e-9);
  std::mt19937 random(32);
  for (const double reach : {400.0, 250.0})
    for (int round = 0; round < 100; ++round) {
      const JointVector q = anyWithin(t3.limits, random);
      const Vector3d elbow(225.0 * std::cos(q[0]), 225.0 * std::sin(q[0]), 0.0);
      const Vector3d fore(175.0 * std::cos(q[0] + q[1]), 175.0 * std::sin(q[0] + q[1]), 0.0);
      const Vector3d up = Vector3d::UnitZ(), none = Vector3d::Zero();
      Jacobian jacobian(6, 4);
      jacobian.col(0) << up.cross(elbow + fore) / reach, up;
      jacobian.col(1) << up.cross(fore) / reach, up;
      jacobian.col(2) << up, none;
      jacobian.col(3) << none, up;
      EXPECT_NEAR(motion::isotropyAt(t3, q, reach), ratioOf(jacobian), 1e-6);
    }
}

TEST(Margins, SingularPosesHaveNoIsotropy) {
  const robot::RobotModel ur5 = robot::loadRobot("ur5");
  JointVector q(6);
  q << 0.3, -1.2, 1.4, -0.9, 1.1, 0.2;
  EXPECT_GT(motion::isotropyAt(ur5, q, ur5Reach()), 0.02);
  for (const int joint : {2, 4}) { // the elbow or the wrist stretched
    JointVector at = q;
    at[joint] = 0.0;
    EXPECT_LT(motion::isotropyAt(ur5, at, ur5Reach()), 1e-6);
  }
}

// Of more points than one chunk: each joint's least way to either limit, and the first place of it.
TEST(Margins, AreThoseOfTheWorstPoints) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::disc(20));
  std::mt19937 random(33);
  for (const bool upper : {false, true}) {
    plan::Trajectory t;
    t.dof = 6;
    std::size_t worst = 0;
    double minimum = 1.0;
    for (std::size_t i = 0; i < 700; ++i) {
      JointVector q = 0.4 * anyWithin(cell.limits(), random);
      // Joint j is nearest to a limit at point 140 j - 1 and the one behind it; at 0, joint 0.
      const std::size_t j = (i + 1) / 140;
      if (i <= 1 || (i + 1) % 140 <= 1) {
        const robot::JointLimits& limit = cell.limits()[j];
        const double away = 0.01 * static_cast<double>(j + 1);
        q[static_cast<Eigen::Index>(j)] = upper ? limit.max - away : limit.min + away;
      }
      t.joints.insert(t.joints.end(), q.data(), q.data() + 6);
      t.timeS.push_back(static_cast<double>(i));
      const double isotropy = motion::isotropyAt(cell.robot(), q, ur5Reach());
      worst = isotropy < minimum ? i : worst;
      minimum = std::min(minimum, isotropy);
    }
    const motion::MotionMargins margins = motion::marginsOf(t, cell, {});
    ASSERT_EQ(margins.joints.size(), 6u);
    for (std::size_t j = 0; j < 6; ++j) {
      EXPECT_NEAR(margins.joints[j].rad, 0.01 * static_cast<double>(j + 1), 1e-12);
      EXPECT_EQ(margins.joints[j].point, j == 0 ? 0u : 140 * j - 1);
    }
    EXPECT_NEAR(margins.isotropy, minimum, 1e-7);
    EXPECT_EQ(margins.isotropyPoint, worst);
  }
}

// An external axis has its margin too, in mm where it slides; no points, no margin.
TEST(Margins, OfExternalAxesAndOfNothing) {
  const process::Process process = process::loadProcess("fdm-1.0");
  platform::PlatformSolid plate;
  plate.polygon = test::disc(50);
  const robot::Cell cell = robot::loadCell("kr10-r1100-slide", process, plate);
  plan::Trajectory t;
  t.dof = cell.dof();
  EXPECT_EQ(motion::marginsOf(t, cell, {}).isotropy, 1.0);
  EXPECT_EQ(motion::marginsOf(t, cell, {}).joints[0].rad, std::numeric_limits<double>::infinity());
  const robot::JointLimits& slide = cell.limits().back();
  for (const double at : {slide.min + 70.0, slide.max - 25.0, slide.min + 40.0}) {
    JointVector q = cell.home();
    q[q.size() - 1] = at;
    t.joints.insert(t.joints.end(), q.data(), q.data() + q.size());
    t.timeS.push_back(0.0);
  }
  const motion::MotionMargins margins = motion::marginsOf(t, cell, {});
  EXPECT_NEAR(margins.joints.back().rad, 25.0, 1e-9);
  EXPECT_EQ(margins.joints.back().point, 1u);
  EXPECT_EQ(margins.isotropyPoint, 0u) << "the arm stands";
}
