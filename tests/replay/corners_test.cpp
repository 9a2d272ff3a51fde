// Blended corners, speeds and limits of an executed program, in closed form.
#include "base/run_context.h"
#include "base/units.h"
#include "replay/controller_time.h"
#include "replay/executed_path.h"
#include "replay/replay_scene.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace voluta::replay {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using plan::ProgramMotion;
using plan::ReadProgram;

// Directions lean in one plane, so that turning them evenly is a sum of angles.
struct Place {
  Vector3d at;
  double lean;
};
Vector3d leaning(double angle) {
  return {std::sin(angle), 0.0, std::cos(angle)};
}

ReadProgram program(const std::vector<Place>& places, const std::vector<double>& blends) {
  ReadProgram read;
  for (std::size_t i = 0; i < places.size(); ++i) {
    ProgramMotion m;
    m.target = plan::TargetKind::ToolPoint;
    m.position = places[i].at;
    m.direction = leaning(places[i].lean);
    m.speedMmPerS = 20.0;
    m.blendMm = blends[i];
    m.extruding = true;
    read.motions.push_back(m);
  }
  return read;
}

// The same as poses of the nozzle in the work frame of a cell with a fixed nozzle.
ReadProgram asPoses(ReadProgram read, const robot::Cell& cell) {
  read.flange_T_tcp = cell.flange_T_moved();
  for (ProgramMotion& m : read.motions) {
    m.target = plan::TargetKind::WorkPose;
    const Vector3d z = -m.direction, y = Vector3d::UnitY();
    m.frame_T_tcp = Isometry3d::Identity();
    m.frame_T_tcp.linear() << y.cross(z), y, z;
    m.frame_T_tcp.translation() = m.position;
  }
  return read;
}

// Where the way is `s` along the straight one from place m - 1 to m: by the parabola (Bernstein)
// within a blend, which has at most half of the ways on both sides.
Place pathAt(const std::vector<Place>& p, const std::vector<double>& blends, std::size_t m,
             double s) {
  const auto lengthTo = [&](std::size_t k) { return (p[k].at - p[k - 1].at).norm(); };
  const auto blendAt = [&](std::size_t k) {
    return k == 0 || k + 1 == p.size()
               ? 0.0
               : std::min({blends[k], 0.5 * lengthTo(k), 0.5 * lengthTo(k + 1)});
  };
  const auto on = [&](std::size_t k, double mm) { // of the way to place k, from its start
    const double t = mm / lengthTo(k);
    return Place{(1 - t) * p[k - 1].at + t * p[k].at, (1 - t) * p[k - 1].lean + t * p[k].lean};
  };
  const double length = lengthTo(m), before = blendAt(m - 1), after = blendAt(m);
  std::size_t corner = 0;
  double v = 0.0; // along the parabola
  if (s * length < before) {
    corner = m - 1;
    v = 0.5 + s * length / before / 2;
  } else if ((1 - s) * length < after) {
    corner = m;
    v = (1 - (1 - s) * length / after) / 2;
  } else {
    return on(m, s * length);
  }
  const double r = blendAt(corner);
  const Place a = on(corner, lengthTo(corner) - r), b = p[corner], c = on(corner + 1, r);
  const double wa = (1 - v) * (1 - v), wb = 2 * v * (1 - v), wc = v * v;
  return {wa * a.at + wb * b.at + wc * c.at, wa * a.lean + wb * b.lean + wc * c.lean};
}

const std::vector<Place> kPlaces{{{-8, 1, 4}, 0.0},  {{2, 1, 4}, 0.3},   {{2, 7, 4}, -0.2},
                                 {{5, 9, 6}, 0.4},   {{5, 10, 6}, 0.1},  {{-6, 4, 6}, -0.3},
                                 {{-6, 4, 12}, 0.2}, {{-6, 9, 12}, 0.25}};
const std::vector<double> kBlends{3.0, 2.0, 2.5, 1.5, 0.4, 0.0, 2.0, 1.0};

void expectWay(const ExecutedPath& path, const std::vector<Place>& places,
               const std::vector<double>& blends) {
  ASSERT_EQ(path.firstSample.size(), places.size() + 1);
  for (std::size_t m = 1; m < places.size(); ++m) {
    const std::size_t first = path.firstSample[m], n = path.firstSample[m + 1] - first;
    for (std::size_t k = 0; k < n; ++k) {
      const Place wanted =
          pathAt(places, blends, m, static_cast<double>(k + 1) / static_cast<double>(n));
      EXPECT_LT((path.tip[first + k] - wanted.at).norm(), 1e-9) << m << ' ' << k;
      EXPECT_LT((path.direction[first + k] - leaning(wanted.lean)).norm(), 1e-9) << m << ' ' << k;
    }
    EXPECT_LT((path.targetTip[m] - places[m].at).norm(), 1e-9);
    EXPECT_LT((path.targetDirection[m] - leaning(places[m].lean)).norm(), 1e-9);
  }
}

TEST(Corners, AreParabolasFromBlendToBlend) {
  expectWay(executeToolPoints(program(kPlaces, kBlends), {}), kPlaces, kBlends);
}

TEST(Corners, AreTheSameOfPosesInTheWorkFrame) {
  test::usesSourceTreeResources();
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::squarePlatform(30.0));
  expectWay(executeProgram(asPoses(program(kPlaces, kBlends), cell), cell, {}), kPlaces, kBlends);
}

TEST(Corners, AreAsSharpAsTheyTurnAndTakeNoTimeOfTheirOwn) {
  const ExecutedPath path = executeToolPoints(program(kPlaces, kBlends), {});
  double begins = 0.0;
  for (std::size_t m = 0; m < kPlaces.size(); ++m) {
    const double length = m == 0 ? 0.0 : (kPlaces[m].at - kPlaces[m - 1].at).norm();
    EXPECT_NEAR(path.commandedMm[m], length, 1e-12);
    EXPECT_NEAR(path.durationS[m], length / 20.0, 1e-12);
    EXPECT_NEAR(path.startS[m], begins, 1e-12);
    begins += length / 20.0;
    double corner = 0.0;
    if (m > 0 && m + 1 < kPlaces.size()) {
      const Vector3d in = (kPlaces[m].at - kPlaces[m - 1].at).normalized();
      const Vector3d out = (kPlaces[m + 1].at - kPlaces[m].at).normalized();
      corner = 2.0 * std::asin(0.5 * (out - in).norm());
    }
    EXPECT_NEAR(path.cornerRad[m], corner, 1e-9);
    EXPECT_EQ(path.angleRad[m], 0.0);
  }
  EXPECT_NEAR(path.totalS(), begins, 1e-12);
}

// Two blends on one way may fill it, not more; the violation has the way's length and the sum of
// the two.
TEST(Corners, OverlapIfTwoBlendsExceedTheirWay) {
  const std::vector<Place> places{
      {{0, 0, 0}, 0}, {{9, 0, 0}, 0}, {{9, 4, 0}, 0}, {{0, 4, 0}, 0}, {{0, 0, 0}, 0}};
  const auto overlaps = [&](double first, double second) {
    return executeToolPoints(program(places, {0, first, second, 0, 0}), {}).violations;
  };
  EXPECT_TRUE(overlaps(2.0, 2.0).empty());
  EXPECT_TRUE(overlaps(4.5, 0.0).empty());
  EXPECT_TRUE(overlaps(0.0, 4.5).empty());
  const auto found = overlaps(1.5, 2.6);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, LimitKind::BlendOverlap);
  EXPECT_EQ(found[0].motion, 2u);
  EXPECT_NEAR(found[0].value, 4.1, 1e-12);
  EXPECT_NEAR(found[0].limit, 4.0, 1e-12);
}

// A way of its own between two targets: at equal steps of time, straight between its points.
TEST(Corners, AWayOfPointsIsPassedAtEqualSteps) {
  ReadProgram read = program({{{0, 0, 0}, 0.0}, {{0, 9, 0}, 0.3}}, {0, 0});
  const std::vector<Place> targets{{{4, 0, 0}, 0.2}, {{4, 6, 0}, -0.1}};
  for (const Place& p : targets)
    read.motions[1].viaPoints.push_back({p.at, leaning(p.lean)});
  const ExecutedPath path = executeToolPoints(read, {});
  EXPECT_NEAR(path.commandedMm[1], 4.0 + 6.0 + 5.0, 1e-12);
  EXPECT_NEAR(path.durationS[1], 15.0 / 20.0, 1e-12);
  const std::vector<Place> all{{{0, 0, 0}, 0.0}, targets[0], targets[1], {{0, 9, 0}, 0.3}};
  const std::size_t first = path.firstSample[1], n = path.firstSample[2] - first;
  for (std::size_t k = 0; k < n; ++k) {
    const double at = 3.0 * static_cast<double>(k + 1) / static_cast<double>(n);
    const auto piece = std::min<std::size_t>(2, static_cast<std::size_t>(at));
    const double t = at - static_cast<double>(piece);
    const Place &a = all[piece], &b = all[piece + 1];
    EXPECT_LT((path.tip[first + k] - (1 - t) * a.at - t * b.at).norm(), 1e-9);
    EXPECT_LT((path.direction[first + k] - leaning((1 - t) * a.lean + t * b.lean)).norm(), 1e-9);
    const Vector3d last = k == 0 ? Vector3d::Zero() : path.tip[first + k - 1];
    EXPECT_LE((path.tip[first + k] - last).norm(), 0.5 + 1e-9);
  }
  EXPECT_LE(n, 60u) << "no finer than it needs to be";
}

class JointMotions : public testing::Test {
protected:
  JointMotions() { test::usesSourceTreeResources(); }
  process::Process process_ = (test::usesSourceTreeResources(), process::loadProcess("fdm-1.0"));
  robot::Cell cell_ = robot::loadCell("ur5-fixed", process_, test::squarePlatform(30.0));

  static ProgramMotion to(const robot::JointVector& q, double speed, double duration = 0.0) {
    ProgramMotion m;
    m.joints.assign(q.data(), q.data() + q.size());
    m.jointInterpolated = true;
    m.jointSpeedRadPerS = speed;
    m.durationS = duration;
    return m;
  }
};

TEST_F(JointMotions, TurnAllJointsInProportionInTheTimeOfTheOneThatTurnsFurthest) {
  robot::JointVector a = cell_.home(), b = a;
  b[0] += 0.2;
  b[3] -= 0.5;
  ReadProgram read;
  read.motions = {to(a, 0.0), to(b, 0.4), to(a, 0.4, 3.0)};
  const ExecutedPath path = executeProgram(read, cell_, {});
  EXPECT_TRUE(path.arm);
  EXPECT_TRUE(path.violations.empty());
  EXPECT_NEAR(path.durationS[1], 0.5 / 0.4, 1e-12);
  EXPECT_NEAR(path.durationS[2], 3.0, 1e-12) << "the time that the text gives rules";
  EXPECT_NEAR(path.totalS(), 0.5 / 0.4 + 3.0, 1e-12);
  const std::size_t first = path.firstSample[1], n = path.firstSample[2] - first;
  for (std::size_t k = 0; k < n; ++k) {
    const double u = static_cast<double>(k + 1) / static_cast<double>(n);
    const Isometry3d pose = cell_.work_T_tool(a + u * (b - a));
    EXPECT_LT((path.tip[first + k] - pose.translation()).norm(), 1e-9);
    EXPECT_LT((path.direction[first + k] + pose.linear().col(2)).norm(), 1e-9);
    const Vector3d last = k == 0 ? path.targetTip[0] : path.tip[first + k - 1];
    EXPECT_LE((path.tip[first + k] - last).norm(), 1.0 + 1e-6) << "a travel";
  }
  std::size_t steps = 0;
  for (std::size_t k = 1; k < path.armMotion.size(); ++k) {
    const double* q = path.armJoints.data() + 6 * k;
    const bool there = path.armMotion[k] == 1;
    const double u = there ? path.armFraction[k] : 1.0 - path.armFraction[k];
    for (int j = 0; j < 6; ++j) {
      EXPECT_NEAR(q[j], a[j] + u * (b[j] - a[j]), 1e-6);
      EXPECT_LE(std::abs(q[j] - q[j - 6]), 0.03 + 1e-9);
    }
    steps += there ? 1 : 0;
  }
  EXPECT_EQ(steps, 17u); // 0.5 rad in steps of 0.03 at most
}

TEST_F(JointMotions, OneTargetIsAnArmAtRest) {
  ReadProgram read;
  EXPECT_FALSE(executeProgram(read, cell_, {}).arm);
  read.motions = {to(cell_.home(), 0.0)};
  const ExecutedPath path = executeProgram(read, cell_, {});
  EXPECT_TRUE(path.arm);
  EXPECT_EQ(path.dof, 6);
  EXPECT_EQ(path.totalS(), 0.0);
  ASSERT_EQ(path.joints.size(), 6u);
  for (int j = 0; j < 6; ++j)
    EXPECT_EQ(path.jointsAt(0)[j], cell_.home()[j]);
  const Isometry3d pose = cell_.work_T_tool(cell_.home());
  ASSERT_EQ(path.tip.size(), 1u);
  EXPECT_LT((path.tip[0] - pose.translation()).norm(), 1e-9);
  EXPECT_LT((path.direction[0] + pose.linear().col(2)).norm(), 1e-9);
}

// From rest to rest by the joint that turns furthest: a trapezoid, or a triangle where it is short.
TEST_F(JointMotions, TakeLongerWithRamps) {
  for (const double rotation : {0.5, 0.02}) {
    robot::JointVector a = cell_.home(), b = a;
    b[1] -= rotation;
    b[3] += 0.4 * rotation;
    ReadProgram read;
    read.motions = {to(a, 0.0), to(b, 0.4), to(a, 0.0, 0.7)};
    const ExecutedPath path = executeProgram(read, cell_, {});
    const double acceleration = 2.0, up = 0.4 * 0.4 / acceleration; // rad of both ramps
    const double ramped = rotation > up ? rotation / 0.4 + 0.4 / acceleration
                                        : 2.0 * std::sqrt(rotation / acceleration);
    EXPECT_NEAR(jointMotionS(path, 1, 0.0), rotation / 0.4, 1e-9);
    EXPECT_NEAR(jointMotionS(path, 1, acceleration), ramped, 1e-9);
    // By the motion's own acceleration, else by its controller's; a motion with a time takes that.
    read.time.jointAccelerationRadPerS2 = acceleration;
    std::vector<double> seconds = controllerTimes(read, path, RotationLaw::Text);
    ASSERT_EQ(seconds.size(), 3u);
    EXPECT_EQ(seconds[0], 0.0);
    EXPECT_NEAR(seconds[1], ramped, 1e-9);
    EXPECT_NEAR(seconds[2], 0.7, 1e-9);
    read.motions[1].jointAccelerationRadPerS2 = 1e9;
    EXPECT_NEAR(controllerTimes(read, path, RotationLaw::Text)[1], rotation / 0.4, 1e-6);
  }
}

// Straight to a target that only another branch reaches: the joints jump, which is a violation.
TEST_F(JointMotions, JumpToAnotherBranchIsAViolation) {
  robot::JointVector a = cell_.home(), b = a;
  b[0] += base::kPi;
  ReadProgram read;
  read.motions = {to(a, 0.0), to(b, 0.0, 5.0)};
  read.motions[1].jointInterpolated = false;
  const ExecutedPath path = executeProgram(read, cell_, {});
  ASSERT_FALSE(path.violations.empty());
  bool reported = false;
  for (const LimitViolation& v : path.violations)
    reported = reported || (v.kind == LimitKind::BranchJump && v.motion == 1 && v.joint == 0 &&
                            v.value > 1.0 && v.limit == 1.0);
  EXPECT_TRUE(reported);
}

TEST_F(JointMotions, NameTheJointThatIsTooFastAndItsSpeed) {
  robot::JointVector a = cell_.home(), b = a;
  b[1] += 0.3;
  b[4] += 0.25;
  const double limit = cell_.limits()[1].velocity;
  for (const double share : {0.5, 0.99, 1.1, 2.0}) {
    ReadProgram read;
    read.motions = {to(a, 0.0), to(b, 0.0, 0.3 / (share * limit)), to(a, 0.2)};
    const ExecutedPath path = executeProgram(read, cell_, {});
    ASSERT_EQ(path.violations.size(), share > 1.0 ? 1u : 0u) << share;
    if (share < 1.0)
      continue;
    const LimitViolation& v = path.violations[0];
    EXPECT_EQ(v.kind, LimitKind::JointSpeed);
    EXPECT_EQ(v.motion, 1u);
    EXPECT_EQ(v.joint, 1);
    EXPECT_NEAR(v.value, share * limit, 1e-3 * limit);
    EXPECT_NEAR(v.limit, limit, 1e-12);
  }
}

TEST_F(JointMotions, NameTheJointOutOfItsRangeAndThePlace) {
  for (const double beyond : {-1e-3, 5e-5, 1e-3}) {
    for (const bool upper : {false, true}) {
      const robot::JointLimits& limits = cell_.limits()[2];
      robot::JointVector q = cell_.home();
      q[2] = upper ? limits.max + beyond : limits.min - beyond;
      ReadProgram read;
      read.motions = {to(cell_.home(), 0.0), to(q, 0.5), to(cell_.home(), 0.5)};
      const ExecutedPath path = executeProgram(read, cell_, {});
      ASSERT_EQ(path.violations.size(), beyond > 1e-4 ? 1u : 0u) << beyond;
      if (beyond < 1e-4)
        continue;
      EXPECT_EQ(path.violations[0].kind, LimitKind::JointRange);
      EXPECT_EQ(path.violations[0].motion, 1u);
      EXPECT_EQ(path.violations[0].joint, 2);
      EXPECT_NEAR(path.violations[0].value, q[2], 1e-12);
      EXPECT_NEAR(path.violations[0].limit, upper ? limits.max : limits.min, 1e-12);
    }
  }
}

// By a pose the arm turns on from where it is; a straight motion does not change its branch.
TEST_F(JointMotions, ATurnOnTheSpotTakesAsLongAsItsJointsNeed) {
  robot::JointVector a = cell_.home(), b = a;
  b[5] += 0.6;
  ReadProgram read;
  read.flange_T_tcp = Isometry3d(Eigen::Translation3d(0, 0, 100));
  read.motions = {to(a, 0.0), to(a, 0.0)};
  ProgramMotion& rotation = read.motions[1];
  rotation.target = plan::TargetKind::FlangePose;
  rotation.jointInterpolated = false;
  rotation.speedMmPerS = 50.0;
  rotation.frame_T_tcp = cell_.robot().kinematics->flange(b) * read.flange_T_tcp;
  const ExecutedPath path = executeProgram(read, cell_, {});
  EXPECT_TRUE(path.violations.empty());
  EXPECT_NEAR(path.commandedMm[1], 0.0, 1e-9);
  EXPECT_NEAR(path.angleRad[1], 0.6, 1e-9);
  EXPECT_NEAR(path.durationS[1], 0.6 / cell_.limits()[5].velocity, 1e-9);
  for (int j = 0; j < 6; ++j)
    EXPECT_NEAR(path.jointsAt(1)[j], b[j], 1e-9);
  // In steps of 2 degrees at most.
  EXPECT_EQ(std::count(path.armMotion.begin(), path.armMotion.end(), 1u),
            std::lround(std::ceil(base::radiansToDegrees(0.6) / 2.0)));
}

} // namespace
} // namespace voluta::replay
