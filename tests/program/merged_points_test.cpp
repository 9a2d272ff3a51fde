// Trajectories with fewer points, for controllers that plan each motion in time.
#include "program_fixture.h"

#include "base/units.h"
#include "program/common/motion_targets.h"
#include "program/dialect.h"

namespace voluta::program {
namespace {

using MergedPointsOf = test::Programs;

// A bead along a circle in steps of 0.1 mm: joined to motions that the controller can plan in time,
// within the stated tolerance; a bend and another section stay.
TEST_F(MergedPointsOf, shortMotionsAreJoinedWithinTheirTolerance) {
  useRod();
  const double d = base::kPi / 180.0;
  append(plan::MoveKind::Joint, {0, 10 * d, 20 * d, 0, 60 * d, 0, 0}, 0.0, 0.0);
  const double reach = std::hypot(420.0, 100.0); // about; the tip turns with joint 1
  for (int i = 1; i <= 2000; ++i)
    append(plan::MoveKind::Print, {i * 0.1 / reach, 10 * d, 20 * d, 0, 60 * d, 0, 0}, 0.006,
           i <= 1000 ? 0.08 : 0.1);
  append(plan::MoveKind::Linear, {0.5, 10 * d, 20 * d, 0, 60 * d, 0, 0}, 1.0, 0.0);
  const MergedPoints merged = mergedPoints(input(), findDialect("rapid").merge, {});
  EXPECT_EQ(pointsFor("rapid", input()).trajectory->joints, trajectory_.joints); // on a rod
  EXPECT_GT(pointsFor("rapid", input()).trajectory->timeS.back(), 2000 * 0.02);
  const plan::Trajectory& t = *merged.trajectory;
  EXPECT_LT(t.pointCount(), 550u);
  EXPECT_NEAR(t.timeS.back(), trajectory_.timeS.back(), 0.05); // two short ones are slowed
  EXPECT_DOUBLE_EQ(t.extrudedMm3.back(), trajectory_.extrudedMm3.back());
  ASSERT_EQ(merged.pointOf.size(), trajectory_.pointCount());
  const auto tip = [&](const plan::Trajectory& of, std::size_t i) {
    return Eigen::Vector3d(
        cell_->work_T_tool(Eigen::Map<const Eigen::VectorXd>(of.at(i), 7)).translation());
  };
  std::size_t tooShort = 0;
  for (std::size_t i = 1; i + 1 < t.pointCount(); ++i)
    tooShort += t.timeS[i] - t.timeS[i - 1] < 0.024 || (tip(t, i) - tip(t, i - 1)).norm() < 0.5;
  EXPECT_LE(tooShort, 2u); // where the section changes and at the end
  for (std::size_t i = 1; i < trajectory_.pointCount(); ++i) {
    const std::size_t to = merged.pointOf[i];
    ASSERT_TRUE(to > 0 && t.timeS[to] >= trajectory_.timeS[i] - 1e-12);
    const Eigen::Vector3d a = tip(t, to - 1), step = tip(t, to) - a, p = tip(trajectory_, i);
    ASSERT_LE((p - a - step * (p - a).dot(step) / step.squaredNorm()).norm(), 0.004);
    const double section = (t.extrudedMm3[to] - t.extrudedMm3[to - 1]) / step.norm();
    const double own = (trajectory_.extrudedMm3[i] - trajectory_.extrudedMm3[i - 1]) /
                       (p - tip(trajectory_, i - 1)).norm();
    if (trajectory_.move[i] == plan::MoveKind::Print) {
      ASSERT_NEAR(section, own, 0.021 * own);
    }
  }
  EXPECT_EQ(pointsFor("urscript", input()).trajectory->joints, trajectory_.joints);
}

// Motions still too short take as long as the controller needs: the same way and material, and
// later ones are delayed.
TEST_F(MergedPointsOf, motionsThatStayTooShortAreSlowed) {
  const double d = base::kPi / 180.0;
  append(plan::MoveKind::Joint, {0, -90 * d, 90 * d, 0, 90 * d, 0}, 0.0, 0.0);
  for (int i = 1; i <= 40; ++i) // a zigzag: nothing can be joined
    append(plan::MoveKind::Print, {i * 0.002, -90 * d, (i % 2 == 0 ? 90 : 91) * d, 0, 90 * d, 0},
           i % 4 == 0 ? 0.005 : 0.05, 0.1);
  MergeLimits limits = findDialect("rapid").merge;
  const MergedPoints slowed = mergedPoints(input(), limits, {});
  const plan::Trajectory& t = *slowed.trajectory;
  ASSERT_EQ(t.pointCount(), trajectory_.pointCount());
  EXPECT_EQ(t.joints, trajectory_.joints);
  EXPECT_EQ(t.extrudedMm3, trajectory_.extrudedMm3);
  for (std::size_t i = 1; i < t.pointCount(); ++i)
    EXPECT_NEAR(t.timeS[i] - t.timeS[i - 1], i % 4 == 0 ? 0.02 : 0.05, 1e-12) << i;
  limits.motionS = 0.0;
  EXPECT_EQ(mergedPoints(input(), limits, {}).trajectory->timeS, trajectory_.timeS);
}

// Pieces of one joint motion are one, at which the arm does not stop; a bend in joint space,
// another kind of motion and the first point stay. Poses for another maker's arm keep their pieces.
TEST_F(MergedPointsOf, piecesOfAJointMotionAreOne) {
  const auto joints = [](double a, double b) { return std::vector<double>{a, b, 1.5, 0, 1.5, 0}; };
  append(plan::MoveKind::Joint, joints(0.0, -1.5), 0.0, 0.0);
  for (int i = 1; i <= 3; ++i)
    append(plan::MoveKind::Joint, joints(0.3 * i, -1.5 + 0.1 * i), 0.5, 0.0);
  append(plan::MoveKind::Joint, joints(0.6, -1.2), 0.5, 0.0); // back, on another line
  append(plan::MoveKind::Joint, joints(0.3, -1.2), 0.5, 0.0);
  append(plan::MoveKind::Linear, joints(0.3, -1.19), 0.5, 0.0);
  append(plan::MoveKind::Joint, joints(0.2, -1.19), 0.5, 0.0);
  const MergedPoints merged = mergedPoints(input(), {.jointRad = 1e-5}, {});
  EXPECT_EQ(merged.pointOf, (std::vector<std::size_t>{0, 1, 1, 1, 2, 2, 3, 4}));
  EXPECT_EQ(merged.trajectory->timeS, (std::vector<double>{0.0, 1.5, 2.5, 3.0, 3.5}));
  for (std::size_t i = 0; i < merged.pointOf.size(); ++i)
    if (i + 1 == merged.pointOf.size() || merged.pointOf[i + 1] != merged.pointOf[i]) {
      EXPECT_EQ(merged.trajectory->at(merged.pointOf[i])[0], trajectory_.at(i)[0]) << i;
    }
  EXPECT_EQ(mergedPoints(input(), {}, {}).trajectory->joints, trajectory_.joints);
  append(plan::MoveKind::Joint, joints(0.2, -1.19), 0.0,
         0.0); // a print ends, and is taken up again
  EXPECT_EQ(mergedPoints(input(), {.jointRad = 1e-5}, {}).trajectory->pointCount(), 6u);
  EXPECT_EQ(pointsFor("rapid", input()).trajectory->joints,
            trajectory_.joints); // poses, to this arm
  EXPECT_EQ(pointsFor("urscript", input()).trajectory->pointCount(), 6u);
}

// Ramps up and down at 2 rad/s2 with a stretch at 0.5 rad/s take a quarter of a second more than
// the way at that speed; a time that no speed meets gets the greatest that the ramps allow.
TEST(RampedSpeed, takesTheTime) {
  EXPECT_NEAR(rampedSpeed(1.0, 1.0 / 0.5 + 0.5 / 2.0, 2.0), 0.5, 1e-12);
  EXPECT_NEAR(rampedSpeed(1.0, 2.0 * std::sqrt(0.5), 2.0), std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(rampedSpeed(1.0, 1.41, 2.0), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(rampedSpeed(1.0, 0.9, 100.0), 1.1251781, 1e-6);
}

} // namespace
} // namespace voluta::program
