// Check values, round trips and branches of the ortho-parallel family's closed-form inverse.
#include "joints_in_degrees.h"
#include "resource_fixture.h"

#include "base/units.h"
#include "robot/kinematics/opw_kinematics.h"
#include "robot/robot_model.h"

#include <gmock/gmock.h>
#include <random>

namespace voluta::robot {
namespace {

using base::kPi;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using test::joints;

// The published check values give the IRB 2400's third joint as its URDF does.
const OpwGeometry kIrb1200{0, -42, 0, 399.1, 350, 351, 82, {0, 0, -kPi / 2, 0, 0, 0}};
const OpwGeometry kIrb2400{100, -135, 0, 615, 705, 755, 85, {0, 0, -kPi / 2, 0, 0, 0}};
const OpwGeometry kRv2f{0, -50, 0, 295, 230, 270, 70, {}};
// No arm of any maker: every parameter takes part.
const OpwGeometry kOdd{70, 30, 25, 300, 280, 310, 60, {0.3, -0.4, 1.1, 0.5, -0.2, 2.0}};
const std::vector<OpwGeometry> kAll = {kIrb1200, kIrb2400, kRv2f, kOdd};

double angleBetweenFrames(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return (a - b).norm() / std::sqrt(2.0);
}
double jointDistance(const JointVector& a, const JointVector& b) {
  double worst = 0.0;
  for (int i = 0; i < 6; ++i)
    worst = std::max(worst, std::abs(std::remainder(a[i] - b[i], 2 * kPi)));
  return worst;
}

// The IRB 1200 by its URDF: fixed offsets between turns about single axes, and nothing of the
// family's parameters.
std::vector<Isometry3d> urdfFrames(const JointVector& q) {
  struct Joint {
    Vector3d origin, axis;
  };
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const Joint chain[6] = {{{0, 0, 399.1}, z}, {{0, 0, 0}, y},   {{0, 0, 350}, y},
                          {{0, 0, 42}, x},    {{351, 0, 0}, y}, {{82, 0, 0}, x}};
  std::vector<Isometry3d> frames{Isometry3d::Identity()};
  for (int i = 0; i < 6; ++i)
    frames.push_back(frames.back() * Eigen::Translation3d(chain[i].origin) *
                     Eigen::AngleAxisd(q[i], chain[i].axis));
  frames.push_back(frames.back() * Eigen::AngleAxisd(kPi / 2, y));
  return frames;
}

class RandomJoints {
public:
  explicit RandomJoints(unsigned seed) : random_(seed) {}
  JointVector next() {
    JointVector q(6);
    for (int i = 0; i < 6; ++i)
      q[i] = angle_(random_);
    return q;
  }

private:
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> angle_{-kPi, kPi};
};

class Opw : public test::WithResources {};

TEST_F(Opw, checkValues) {
  const double h = std::sqrt(0.5);
  struct Row {
    OpwGeometry geometry;
    JointVector q;
    Vector3d p;
    Eigen::Quaterniond rotation;
  };
  const JointVector zero = joints({0, 0, 0, 0, 0, 0}), bent = joints({0, 0, 0, 0, 90, 0});
  const Row rows[] = {
      {kIrb1200, zero, {433, 0, 791.1}, {h, 0, h, 0}},
      {kIrb1200, bent, {351, 0, 709.1}, {0, 0, 1, 0}},
      {kIrb2400, zero, {940, 0, 1455}, {h, 0, h, 0}},
      {kIrb2400, bent, {855, 0, 1370}, {0, 0, 1, 0}},
      {kRv2f, zero, {-50, 0, 865}, {1, 0, 0, 0}},
      {kRv2f, joints({0, 0, 90, 0, 90, 0}), {270, 0, 505}, {0, 0, 1, 0}},
  };
  for (const Row& row : rows) {
    const Isometry3d flange = OpwKinematics(row.geometry).flange(row.q);
    EXPECT_LT((flange.translation() - row.p).norm(), 1e-3);
    EXPECT_LT(angleBetweenFrames(flange.linear(), row.rotation.matrix()), 1e-12);
  }
  const RobotModel irb1200 = loadRobot("irb1200");
  EXPECT_LT((irb1200.kinematics->flange(zero).translation() - rows[0].p).norm(), 1e-3);
  EXPECT_LT((irb1200.kinematics->flange(bent).translation() - rows[1].p).norm(), 1e-3);
}

TEST_F(Opw, linksAreThoseOfTheMakersDescription) {
  const RobotModel robot = loadRobot("irb1200");
  RandomJoints random(1);
  std::vector<Isometry3d> links;
  for (int n = 0; n < 2000; ++n) {
    const JointVector q = random.next();
    const std::vector<Isometry3d> urdf = urdfFrames(q);
    robot.kinematics->linkPoses(q, links);
    ASSERT_EQ(links.size(), urdf.size());
    for (std::size_t i = 0; i < links.size(); ++i)
      EXPECT_TRUE(links[i].isApprox(urdf[i], 1e-13)) << "frame " << i;
    EXPECT_TRUE(robot.kinematics->flange(q).isApprox(urdf.back(), 1e-13));
  }
}

TEST_F(Opw, linksEndInTheFlangeForEveryGeometry) {
  RandomJoints random(2);
  std::vector<Isometry3d> links;
  for (const OpwGeometry& geometry : kAll) {
    const OpwKinematics kinematics(geometry);
    kinematics.linkPoses(JointVector::Zero(6), links);
    for (std::size_t i = 0; i < 7; ++i)
      EXPECT_TRUE(links[i].linear().isIdentity(1e-14)) << "frame " << i;
    for (int n = 0; n < 200; ++n) {
      const JointVector q = random.next();
      kinematics.linkPoses(q, links);
      EXPECT_TRUE(links.back().isApprox(kinematics.flange(q), 1e-13));
      // The wrist's axes meet: the flange stays c4 from its centre, along its own z.
      EXPECT_LT(
          (links[5].translation() + geometry.c4 * links[7].linear().col(2) - links[7].translation())
              .norm(),
          1e-10);
    }
  }
}

TEST_F(Opw, inverseThenForwardOverRandomPoses) {
  for (std::size_t g = 0; g < kAll.size(); ++g) {
    SCOPED_TRACE(g);
    const OpwKinematics kinematics(kAll[g]);
    RandomJoints random(3 + static_cast<unsigned>(g));
    std::vector<JointVector> solutions;
    double worstMm = 0.0, worstRad = 0.0;
    std::size_t branches = 0, lost = 0, all = 0;
    constexpr int kPoses = 100000;
    for (int n = 0; n < kPoses; ++n) {
      const JointVector q = random.next();
      const Isometry3d pose = kinematics.flange(q);
      solutions.clear();
      kinematics.inverse(pose, solutions);
      branches += solutions.size();
      all += solutions.size() == 8;
      double nearest = 10.0;
      for (const JointVector& s : solutions) {
        const Isometry3d back = kinematics.flange(s);
        worstMm = std::max(worstMm, (back.translation() - pose.translation()).norm());
        worstRad = std::max(worstRad, angleBetweenFrames(back.linear(), pose.linear()));
        nearest = std::min(nearest, jointDistance(s, q));
        ASSERT_TRUE(s.maxCoeff() <= kPi && s.minCoeff() > -kPi);
      }
      for (std::size_t a = 0; a < solutions.size(); ++a)
        for (std::size_t b = a + 1; b < solutions.size() && n < 2000; ++b)
          EXPECT_GT(jointDistance(solutions[a], solutions[b]), 1e-6);
      lost += nearest > 1e-5;
    }
    EXPECT_LE(worstMm, 1e-8);
    EXPECT_LE(worstRad, 1e-12);
    EXPECT_EQ(lost, 0u);
    EXPECT_GT(branches, 4u * kPoses);
    // With no offset of the shoulder a pose reached by one branch is reached by all.
    if (kAll[g].a1 == 0.0) {
      EXPECT_EQ(all, static_cast<std::size_t>(kPoses));
    }
    RecordProperty("worst_mm_e-12_" + std::to_string(g), std::to_string(worstMm * 1e12));
    RecordProperty("worst_rad_e-15_" + std::to_string(g), std::to_string(worstRad * 1e15));
  }
}

TEST_F(Opw, singularPosesAreReached) {
  const auto with = [](JointVector q, int joint, double value) {
    q[joint] = value;
    return q;
  };
  for (std::size_t g = 0; g < kAll.size(); ++g) {
    const OpwGeometry& geometry = kAll[g];
    const OpwKinematics kinematics(geometry);
    const auto offset = [&](int i) { return geometry.offsets[static_cast<std::size_t>(i)]; };
    const JointVector usual = joints({20, 15, -30, 40, 55, 70});
    const double stretched = offset(2) - std::atan2(geometry.a2, geometry.c3);
    struct Row {
      std::string what;
      JointVector q;
      std::size_t maximum;
    };
    // With the shoulder off axis 1 the arm turned round is not stretched when this one is.
    const std::size_t straight = geometry.a1 == 0.0 ? 4 : 6;
    std::vector<Row> rows = {
        {"all at zero", JointVector::Zero(6), 8},
        {"stretched", with(usual, 2, stretched), straight},
        {"all but stretched", with(usual, 2, stretched + 1e-7), 8},
        {"folded", with(usual, 2, stretched + kPi), straight},
        {"stretched, wrist straight", with(with(usual, 2, stretched), 4, offset(4)), 4}};
    for (const double off : {0.0, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5}) {
      rows.push_back({"wrist straight by " + std::to_string(std::log10(off)),
                      with(usual, 4, offset(4) + off), 8});
      rows.push_back({"wrist folded by " + std::to_string(std::log10(off)),
                      with(usual, 4, offset(4) + kPi - off), 8});
    }
    // The wrist's centre on axis 1: joint 2 turned until the two bars end above the base.
    if (geometry.a1 == 0.0 && geometry.b == 0.0) {
      const double k = std::hypot(geometry.a2, geometry.c3);
      const double beta = usual[2] - offset(2) + std::atan2(geometry.a2, geometry.c3);
      rows.push_back(
          {"wrist on axis 1",
           with(usual, 1,
                offset(1) - std::atan2(k * std::sin(beta), geometry.c2 + k * std::cos(beta))),
           8});
    }
    for (const Row& row : rows) {
      const Isometry3d pose = kinematics.flange(row.q);
      std::vector<JointVector> solutions;
      kinematics.inverse(pose, solutions);
      EXPECT_FALSE(solutions.empty()) << g << ' ' << row.what;
      EXPECT_LE(solutions.size(), row.maximum) << g << ' ' << row.what;
      for (const JointVector& s : solutions) {
        const Isometry3d back = kinematics.flange(s);
        EXPECT_LT((back.translation() - pose.translation()).norm(), 1e-8) << g << ' ' << row.what;
        EXPECT_LT(angleBetweenFrames(back.linear(), pose.linear()), 1e-11) << g << ' ' << row.what;
      }
    }
  }
}

TEST_F(Opw, aFreeJointIsAtItsOffset) {
  const OpwKinematics kinematics(kIrb1200);
  std::vector<JointVector> solutions;
  kinematics.inverse(kinematics.flange(joints({20, 15, -30, 40, 0, 30})), solutions);
  const JointVector wanted = joints({20, 15, -30, 0, 0, 70});
  double nearest = 10.0;
  for (const JointVector& s : solutions)
    nearest = std::min(nearest, jointDistance(s, wanted));
  EXPECT_LT(nearest, 1e-9);
}

TEST_F(Opw, outOfReachGivesNothing) {
  std::vector<JointVector> solutions;
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = Vector3d(800, 0, 400);
  OpwKinematics(kIrb1200).inverse(pose, solutions);
  EXPECT_TRUE(solutions.empty());
  pose.translation() = Vector3d(10, 0, 400); // nearer to axis 1 than b
  OpwKinematics(kOdd).inverse(pose, solutions);
  EXPECT_TRUE(solutions.empty());
  pose.translation() = Vector3d(0, 0, 399.1 + 82); // inside the reach of the folded arm
  OpwKinematics(kIrb1200).inverse(pose, solutions);
  EXPECT_TRUE(solutions.empty());
}

TEST_F(Opw, branchesKeepTheMakersLimits) {
  const RobotModel robot = loadRobot("irb1200");
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<JointVector> solutions;
  std::size_t branches = 0;
  for (int n = 0; n < 5000; ++n) {
    JointVector q(6);
    for (int i = 0; i < 6; ++i) {
      const JointLimits& l = robot.limits[static_cast<std::size_t>(i)];
      q[i] = l.min + unit(random) * (l.max - l.min);
    }
    const Isometry3d pose = robot.kinematics->flange(q);
    inverseNear(robot, pose, q, solutions);
    branches += solutions.size();
    double nearest = 1e9;
    for (const JointVector& s : solutions) {
      nearest = std::min(nearest, (s - q).cwiseAbs().maxCoeff());
      EXPECT_LT((robot.kinematics->flange(s).translation() - pose.translation()).norm(), 1e-8);
      for (int i = 0; i < 6; ++i) {
        EXPECT_GE(s[i], robot.limits[static_cast<std::size_t>(i)].min);
        EXPECT_LE(s[i], robot.limits[static_cast<std::size_t>(i)].max);
      }
    }
    EXPECT_LT(nearest, 1e-5); // whole turns and all
  }
  EXPECT_LT(branches, 8u * 5000u); // limits leave some out
  EXPECT_GT(branches, 2u * 5000u);
}

} // namespace
} // namespace voluta::robot
