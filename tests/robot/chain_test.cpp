// Arms by the poses and axes of a description: recognised, solved, held against the families that
// know them and against a search that knows nothing.
#include "chains.h"
#include "helpers/all_seeds.h"
#include "joints_in_degrees.h"
#include "resource_fixture.h"

#include "robot/kinematics/chain_kinematics.h"

#include <gmock/gmock.h>

namespace voluta::robot {
namespace {

using base::kPi;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using test::MadeArms;

class Chains : public test::WithResources {};

double apart(const JointVector& a, const JointVector& b) {
  double maximum = 0.0;
  for (int i = 0; i < 6; ++i)
    maximum = std::max(maximum, std::abs(std::remainder(a[i] - b[i], 2 * kPi)));
  return maximum;
}

double nearest(const JointVector& q, const std::vector<JointVector>& among) {
  double minimum = 10.0;
  for (const JointVector& other : among)
    minimum = std::min(minimum, apart(q, other));
  return minimum;
}

// Newton's steps from many starts: slow, and finds all solutions.
std::vector<JointVector> searched(const SerialChain& chain, const Isometry3d& pose, int starts,
                                  MadeArms& random) {
  std::vector<JointVector> found;
  for (int n = 0; n < starts; ++n) {
    JointVector q = random.joints();
    const PoseError error = settle(chain, pose, 40, q);
    if (error.mm < 1e-8 && error.rad < 1e-11 && nearest(q, found) > 1e-4)
      found.push_back(q);
  }
  return found;
}

struct Sum {
  double worstMm = 0.0, worstRad = 0.0;
  int lost = 0, twice = 0;
  std::size_t branches = 0;
};
Sum thereAndBack(const ChainKinematics& arm, MadeArms& random, int poses) {
  Sum sum;
  std::vector<JointVector> solutions;
  for (int n = 0; n < poses; ++n) {
    const JointVector q = random.joints();
    const Isometry3d pose = arm.flange(q);
    solutions.clear();
    arm.inverse(pose, solutions);
    sum.branches += solutions.size();
    sum.lost += nearest(q, solutions) > 1e-5;
    for (std::size_t i = 0; i < solutions.size(); ++i) {
      const PoseError error = poseError(arm.flange(solutions[i]), pose);
      sum.worstMm = std::max(sum.worstMm, error.mm);
      sum.worstRad = std::max(sum.worstRad, error.rad);
      for (std::size_t k = 0; k < i; ++k)
        sum.twice += apart(solutions[i], solutions[k]) < 1e-8;
    }
  }
  return sum;
}

struct Shares {
  int found = 0, there = 0, more = 0;
};
Shares againstSearch(const ChainKinematics& arm, MadeArms& random, int poses, int starts) {
  Shares shares;
  std::vector<JointVector> solutions;
  for (int n = 0; n < poses; ++n) {
    const Isometry3d pose = arm.flange(random.joints());
    solutions.clear();
    arm.inverse(pose, solutions);
    const std::vector<JointVector> all = searched(arm.chain(), pose, starts, random);
    for (const JointVector& q : all)
      shares.found += nearest(q, solutions) < 1e-4;
    shares.there += static_cast<int>(all.size());
    shares.more += static_cast<int>(solutions.size()) - static_cast<int>(all.size());
  }
  return shares;
}

TEST_F(Chains, AreAsTheFamiliesThatKnowThem) {
  struct Row {
    const char* id;
    SerialChain chain;
    ArmKind kind;
    Isometry3d controller_T_base;
  };
  const Row rows[] = {
      {"ur5", test::ur5Chain(), ArmKind::ParallelAxes, Isometry3d::Identity()},
      {"irb1200", test::irb1200Chain(), ArmKind::SphericalWrist, Isometry3d::Identity()}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.id);
    const RobotModel known = loadRobot(row.id);
    const ChainKinematics arm(row.chain);
    EXPECT_EQ(arm.kind(), row.kind);
    MadeArms random(1);
    std::vector<JointVector> here, there;
    for (int n = 0; n < 2000; ++n) {
      // The UR's description has joint 1 where the controller has it, and its base half round.
      const JointVector q = random.joints();
      const Isometry3d pose = arm.flange(q);
      const PoseError error = poseError(row.controller_T_base * pose, known.kinematics->flange(q));
      ASSERT_LT(error.mm, 1e-6);
      ASSERT_LT(error.rad, 1e-9);
      here.clear();
      there.clear();
      arm.inverse(pose, here);
      known.kinematics->inverse(row.controller_T_base * pose, there);
      ASSERT_EQ(here.size(), there.size());
      for (const JointVector& solution : there)
        ASSERT_LT(nearest(solution, here), 1e-6);
    }
  }
}

TEST_F(Chains, AreRecognisedForAnyFrames) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    MadeArms made(seed);
    EXPECT_EQ(ChainKinematics(made.sphericalWrist()).kind(), ArmKind::SphericalWrist);
    EXPECT_EQ(ChainKinematics(made.parallelAxes()).kind(), ArmKind::ParallelAxes);
    EXPECT_EQ(ChainKinematics(made.bentWrist()).kind(), ArmKind::BentWrist);
  }
  EXPECT_EQ(ChainKinematics(test::gofaChain()).kind(), ArmKind::BentWrist);
  EXPECT_EQ(ChainKinematics(test::crxChain()).kind(), ArmKind::BentWrist);
}

// Next to where branches fall together a bent wrist's circle may keep one from being seen.
void expectClosed(const ChainKinematics& arm, unsigned seed, int poses) {
  MadeArms random(seed);
  const Sum sum = thereAndBack(arm, random, poses);
  EXPECT_LE(sum.worstMm, 1e-8);
  EXPECT_LE(sum.worstRad, 1e-11);
  EXPECT_LE(sum.lost, arm.kind() == ArmKind::BentWrist ? std::max(2, poses / 5000) : 0);
  EXPECT_EQ(sum.twice, 0);
  EXPECT_GT(sum.branches, static_cast<std::size_t>(2 * poses));
}

TEST_F(Chains, InverseThenForwardOfMakersArms) {
  for (const SerialChain& chain :
       {test::ur5Chain(), test::irb1200Chain(), test::gofaChain(), test::crxChain()})
    expectClosed(ChainKinematics(chain), 2, test::ofSeeds(10000, 100000));
}

TEST_F(Chains, InverseThenForwardOfMadeArms) {
  for (unsigned seed = 0; seed < test::ofSeeds(6u, 20u); ++seed) {
    SCOPED_TRACE(seed);
    MadeArms made(100 + seed);
    expectClosed(ChainKinematics(made.sphericalWrist()), seed, 2000);
    expectClosed(ChainKinematics(made.parallelAxes()), seed, 2000);
    expectClosed(ChainKinematics(made.bentWrist()), seed, 2000);
  }
}

TEST_F(Chains, EveryBranchThatASearchFinds) {
  MadeArms made(7);
  std::vector<SerialChain> chains{test::gofaChain(), test::crxChain()};
  for (int n = 0; n < 4; ++n) {
    chains.push_back(made.sphericalWrist());
    chains.push_back(made.parallelAxes());
    chains.push_back(made.bentWrist());
  }
  for (const SerialChain& chain : chains) {
    const ChainKinematics arm(chain);
    const Shares shares = againstSearch(arm, made, 15, 300);
    EXPECT_EQ(shares.found, shares.there);
    EXPECT_GT(shares.there, 15);
  }
}

TEST_F(Chains, OfOtherArmsNearlyEveryBranch) {
  MadeArms made(8);
  Shares all;
  for (int n = 0; n < 4; ++n) {
    const ChainKinematics arm(made.any());
    EXPECT_EQ(arm.kind(), ArmKind::Other);
    const Shares shares = againstSearch(arm, made, 15, 600);
    all.found += shares.found;
    all.there += shares.there;
    all.more += shares.more;
    const Sum sum = thereAndBack(arm, made, 200);
    EXPECT_LE(sum.worstMm, 1e-6);
    EXPECT_LE(sum.lost, 10);
    EXPECT_EQ(sum.twice, 0);
  }
  EXPECT_GE(all.found, 0.95 * all.there);
}

TEST_F(Chains, SingularPosesAreReachedAndPosesOutOfReachAreNot) {
  for (const SerialChain& chain : {test::ur5Chain(), test::irb1200Chain(), test::gofaChain(),
                                   test::crxChain(), MadeArms(3).any()}) {
    const ChainKinematics arm(chain);
    std::vector<JointVector> solutions;
    for (const JointVector& q :
         {test::joints({0, 0, 0, 0, 0, 0}), test::joints({10, 20, 0, 30, 0, 40}),
          test::joints({0, -30, 60, 0, 90, 0}), test::joints({20, 30, 90, 0, 0, 90})}) {
      const Isometry3d pose = arm.flange(q);
      solutions.clear();
      arm.inverse(pose, solutions);
      EXPECT_FALSE(solutions.empty()) << static_cast<int>(arm.kind()) << " at " << q.transpose();
      for (const JointVector& s : solutions) {
        EXPECT_LT(poseError(arm.flange(s), pose).mm, 1e-6);
        EXPECT_LT(poseError(arm.flange(s), pose).rad, 1e-9);
      }
    }
    Isometry3d far = arm.flange(JointVector::Zero(6));
    far.translation() += Vector3d(4000, 1000, 0);
    solutions.clear();
    arm.inverse(far, solutions);
    EXPECT_TRUE(solutions.empty());
  }
}

// Right angles as descriptions write them, 1.5708: the chain is met as it is written.
TEST_F(Chains, RoundedRightAnglesAreMadeGood) {
  SerialChain chain = test::ur5Chain();
  for (ChainJoint& joint : chain.joints)
    joint.link_T_joint.linear() =
        (joint.link_T_joint.linear() * Eigen::AngleAxisd(4e-6, Vector3d::UnitX())).eval();
  const ChainKinematics arm(chain);
  EXPECT_EQ(arm.kind(), ArmKind::ParallelAxes);
  MadeArms random(4);
  const Sum sum = thereAndBack(arm, random, 2000);
  EXPECT_LE(sum.worstMm, 1e-6);
  EXPECT_LE(sum.lost, 2);
}

} // namespace
} // namespace voluta::robot
