// A change of the wrist's branch spread along a path: the cell "irb1200-moving", whose wrist is
// stretched where the nozzle leans as the forearm.
#include "motion/ladder/branch_blend.h"

#include "base/units.h"
#include "motion/motion.h"
#include "motion/motion_scene.h"
#include "motion/nozzle_frame.h"
#include "motion/sample_plans.h"
#include "motion/timed_points.h"
#include "motion/timing.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

using namespace voluta;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using motion::BlendRefusal;
using robot::JointVector;

namespace {

constexpr int kPoints = 121;

// A straight line of millimetre steps over which the nozzle leans back to the arm all the time.
plan::ToolPlan leaning(double leanRad) {
  plan::ToolPlan plan;
  std::vector<Vector3d> points, directions;
  for (int i = 0; i < kPoints; ++i) {
    points.emplace_back(0.0, i - 0.5 * (kPoints - 1), 60.0);
    directions.emplace_back(-std::sin(leanRad), 0.0, std::cos(leanRad));
  }
  test::appendPath(plan, points, directions, 0);
  return plan;
}

class BranchBlend : public testing::Test {
protected:
  process::Process process_ = process::loadProcess("fdm-1.0");
  robot::Cell cell_ = robot::loadCell("irb1200-moving", process_, plate());
  collision::CellCollision collision_{cell_, process_};
  motion::MotionOptions options_;

  static platform::PlatformSolid plate() {
    platform::PlatformSolid solid;
    solid.polygon = test::disc(20.0);
    return solid;
  }

  std::vector<JointVector> solutionsAt(const plan::ToolPlan& plan, std::size_t w) const {
    std::vector<JointVector> solutions;
    cell_.inverse(motion::toolPose(plan.position[w],
                                   motion::carried(motion::uprightTool(), plan.direction[w])),
                  cell_.home(), solutions);
    return solutions;
  }

  // The lean at which joint 5 is stretched in the middle of the line.
  double stretchedLean() const {
    double best = 0.0, least = 10.0;
    for (double deg = 0.0; deg < 60.0; deg += 0.25) {
      const plan::ToolPlan plan = leaning(base::degreesToRadians(deg));
      for (const JointVector& q : solutionsAt(plan, kPoints / 2))
        if (isInReach(q) && std::abs(q[4]) < least) {
          least = std::abs(q[4]);
          best = base::degreesToRadians(deg);
        }
    }
    return best;
  }

  bool isInReach(const JointVector& q) const {
    for (Eigen::Index j = 0; j < cell_.armDof(); ++j) {
      const auto& l = cell_.robot().limits[static_cast<std::size_t>(j)];
      if (q[j] < l.min || q[j] > l.max)
        return false;
    }
    return true;
  }

  // The path from the first waypoint to `middle`, or from there to the last, with the joints
  // nearest to `q` in the middle and to those before.
  motion::Run runOf(const plan::ToolPlan& plan, JointVector q, std::size_t middle,
                    bool toEnd) const {
    motion::Run run;
    std::vector<JointVector> scratch;
    const std::size_t count = toEnd ? kPoints - middle : middle + 1;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t w = toEnd ? middle + k : middle - k;
      const Quaterniond tool = motion::carried(motion::uprightTool(), plan.direction[w]);
      const JointVector near = q;
      EXPECT_TRUE(motion::solveNear(cell_, plan.position[w], tool, near, 0.5, scratch, q)) << w;
      run.points.push_back({{plan.position[w], tool, q, {}}, w, w, 0.9, plan.speedMmPerS[w]});
    }
    if (!toEnd)
      std::reverse(run.points.begin(), run.points.end());
    run.points.front().volumeMm3 = 0.0;
    return run;
  }

  // The joints of another branch of the wrist there, or of the arm.
  JointVector otherBranch(const plan::ToolPlan& plan, std::size_t w, const JointVector& q,
                          bool arm) const {
    for (const JointVector& s : solutionsAt(plan, w)) {
      const bool flips = (s - q).head(3).cwiseAbs().maxCoeff() > 0.5;
      if (isInReach(s) && flips == arm && std::abs(s[3] - q[3]) > 1.0)
        return s;
    }
    return {};
  }
};

} // namespace

TEST_F(BranchBlend, TheWristChangesAlongThePathWithinTheTolerance) {
  const plan::ToolPlan plan = leaning(stretchedLean() + base::degreesToRadians(0.8));
  const collision::GrowingPart part(plan, 1.0, {});
  const motion::MotionScene scene{plan, cell_, collision_, part, options_};
  constexpr std::size_t kMiddle = kPoints / 2;
  JointVector q;
  for (const JointVector& s : solutionsAt(plan, kMiddle))
    if (isInReach(s) && std::abs(s[4]) < 0.1 && q.size() == 0)
      q = s;
  ASSERT_GT(q.size(), 0);
  const JointVector other = otherBranch(plan, kMiddle, q, false);
  ASSERT_GT(other.size(), 0) << "the wrist has two branches";
  const motion::Run before = runOf(plan, q, kMiddle, false);
  const motion::Run after = runOf(plan, other, kMiddle, true);
  const double cone = base::degreesToRadians(3.0);
  const motion::BlendedRun blended = motion::blendBranches(scene, before, after, cone);
  ASSERT_TRUE(blended.run) << static_cast<int>(blended.why);
  const motion::Run& run = *blended.run;
  std::cout << "over " << blended.points << " points, speed share " << blended.speedShare << "\n";
  EXPECT_LT(blended.speedShare, 1.0);
  ASSERT_EQ(run.ladder.size(), run.points.size());
  double volume = 0.0, greatest = 0.0, turned = 0.0;
  std::size_t waypoints = 0;
  for (std::size_t i = 0; i < run.points.size(); ++i) {
    const motion::RunPoint& p = run.points[i];
    const Eigen::Isometry3d pose = cell_.work_T_tool(p.at.q);
    EXPECT_LT((pose.translation() - p.at.tip).norm(), 1e-3) << i;
    const Vector3d planned = plan.direction[p.next];
    greatest =
        std::max(greatest, std::acos(std::clamp(-pose.linear().col(2).dot(planned), -1.0, 1.0)));
    EXPECT_NEAR(p.at.tip.x(), 0.0, 1e-9);
    EXPECT_NEAR(p.at.tip.z(), 60.0, 1e-9);
    volume += p.volumeMm3;
    waypoints += p.waypoint != plan::kNoWaypoint;
    if (i > 0) {
      EXPECT_LE(scene.span(run.points[i - 1].at.q, p.at.q), options_.maxStepRad) << i;
      turned += std::abs(p.at.q[3] - run.points[i - 1].at.q[3]);
    }
  }
  EXPECT_LE(greatest, cone + 1e-6);
  EXPECT_EQ(waypoints, static_cast<std::size_t>(kPoints));
  EXPECT_NEAR(volume, 0.9 * (kPoints - 1), 1e-9);
  EXPECT_GT(turned, 2.0) << "joint 4 turns to the other branch";
  EXPECT_TRUE(std::abs(std::remainder((run.points.back().at.q - after.points.back().at.q)[3],
                                      base::kTurn)) < 1e-6);
  // Without tolerance the nozzle cannot follow.
  const motion::BlendedRun strict =
      motion::blendBranches(scene, before, after, base::degreesToRadians(0.2));
  EXPECT_FALSE(strict.run);
  EXPECT_EQ(strict.why, BlendRefusal::Tilts);
}

TEST_F(BranchBlend, AnArmThatFlipsIsRefused) {
  const plan::ToolPlan plan = leaning(0.0);
  const collision::GrowingPart part(plan, 1.0, {});
  const motion::MotionScene scene{plan, cell_, collision_, part, options_};
  constexpr std::size_t kMiddle = kPoints / 2;
  bool any = false;
  for (const JointVector& q : solutionsAt(plan, kMiddle))
    for (const JointVector& s : solutionsAt(plan, kMiddle))
      if ((s - q).head(3).cwiseAbs().maxCoeff() > 0.5) {
        motion::Run before, after;
        for (const std::size_t w : {kMiddle - 1, kMiddle})
          before.points.push_back(
              {{plan.position[w], motion::uprightTool(), q, {}}, w, w, 0.9, 20.0});
        for (const std::size_t w : {kMiddle, kMiddle + 1})
          after.points.push_back(
              {{plan.position[w], motion::uprightTool(), s, {}}, w, w, 0.9, 20.0});
        const double turns = std::abs(std::remainder((s - q)[0], base::kTurn)) +
                             std::abs(std::remainder((s - q)[1], base::kTurn)) +
                             std::abs(std::remainder((s - q)[2], base::kTurn));
        const motion::BlendedRun blended = motion::blendBranches(scene, before, after, 0.05);
        EXPECT_FALSE(blended.run);
        if (turns > 1.6) {
          EXPECT_EQ(blended.why, BlendRefusal::ArmFlips);
          any = true;
        }
      }
  EXPECT_TRUE(any);
}

TEST_F(BranchBlend, RunsThatDoNotMeetAreRefused) {
  const plan::ToolPlan plan = leaning(0.0);
  const collision::GrowingPart part(plan, 1.0, {});
  const motion::MotionScene scene{plan, cell_, collision_, part, options_};
  motion::Run before, after;
  for (const std::size_t w : {0, 1})
    before.points.push_back(
        {{plan.position[w], motion::uprightTool(), cell_.home(), {}}, w, w, 0.9, 20.0});
  for (const std::size_t w : {3, 4})
    after.points.push_back(
        {{plan.position[w], motion::uprightTool(), cell_.home(), {}}, w, w, 0.9, 20.0});
  EXPECT_EQ(motion::blendBranches(scene, before, after, 0.05).why, BlendRefusal::Apart);
}
