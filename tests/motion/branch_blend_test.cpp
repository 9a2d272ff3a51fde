// A change of the wrist's branch spread along a path: an IRB 1200 with a straight nozzle, whose
// wrist is stretched where the nozzle leans as the forearm.
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/ladder/branch_blend.h"
#include "motion/motion_options.h"
#include "process/tooling.h"

#include "base/files.h"
#include "base/run_context.h"
#include "base/units.h"
#include "motion/motion.h"
#include "motion/motion_scene.h"
#include "motion/nozzle_frame.h"
#include "motion/sample_plans.h"
#include "motion/timed_points.h"
#include "motion/timing.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voluta;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using motion::BlendRefusal;
using robot::JointVector;

namespace {

constexpr int kPoints = 121;

// A plan of the tips and directions that an arm has with these joints.
plan::ToolPlan planOf(const robot::Cell& cell, const std::vector<JointVector>& joints) {
  plan::ToolPlan plan;
  std::vector<Vector3d> points, directions;
  for (const JointVector& q : joints) {
    const Eigen::Isometry3d pose = cell.work_T_tool(q);
    points.push_back(pose.translation());
    directions.push_back(-pose.linear().col(2));
  }
  test::appendPath(plan, points, directions, 0);
  return plan;
}

class BranchBlend : public testing::Test {
protected:
  process::Process process_ = process::loadProcess("fdm-1.0");
  robot::Cell cell_ = straight();
  collision::CellCollision collision_{cell_, process_};
  motion::MotionOptions options_;

  robot::Cell straight() const {
    using nlohmann::json;
    json cell =
        json::parse(base::readFile(base::resourceFolder() / "cells" / "irb1200-moving.json"));
    cell["id"] = "straight";
    cell["nozzle"] = json::parse(
        R"({"mount": "flange", "pose": {"xyzMm": [0, 0, 200]}, "holder": [{"frustum":
            {"p0Mm": [0, 0, -110], "p1Mm": [0, 0, -175], "r0Mm": 20, "r1Mm": 20}}]})");
    cell["platform"]["pose"]["xyzMm"] = {500, 0, 120};
    cell["platform"]["stem"] = json::parse(
        R"([{"frustum": {"p0Mm": [0, 0, -150], "p1Mm": [0, 0, -10], "r0Mm": 40, "r1Mm": 40}}])");
    cell["homeDeg"] = {0.0, 28.8, -1.5, 0.0, 62.7, 0.0};
    return robot::loadCell(cell.dump(), process_, plate());
  }
  static platform::PlatformSolid plate() {
    platform::PlatformSolid solid;
    solid.polygon = test::disc(20.0);
    return solid;
  }

  // An arc about the first joint, of millimetre steps, along which the wrist is bent by the same
  // angle all the time.
  std::vector<JointVector> arc(double bendRad) const {
    const Eigen::Isometry3d middle = motion::toolPose({0.0, 0.0, 60.0}, motion::uprightTool());
    std::vector<JointVector> solutions;
    cell_.inverse(middle, cell_.home(), solutions);
    JointVector q = solutions.at(0);
    for (const JointVector& s : solutions)
      if (robot::largestRotation(s - cell_.home(), cell_.robot().limits) <
          robot::largestRotation(q - cell_.home(), cell_.robot().limits))
        q = s;
    q[4] = bendRad;
    const double radius = (cell_.work_T_tool(q).translation() -
                           cell_.work_T_tool(turnedBase(q, base::kPi)).translation())
                              .norm() /
                          2.0;
    std::vector<JointVector> joints;
    for (int i = 0; i < kPoints; ++i)
      joints.push_back(turnedBase(q, (i - 0.5 * (kPoints - 1)) / radius));
    return joints;
  }
  static JointVector turnedBase(JointVector q, double by) {
    q[0] += by;
    return q;
  }
  static JointVector otherWrist(JointVector q) {
    q[3] += q[3] > 0.0 ? -base::kPi : base::kPi;
    q[4] = -q[4];
    q[5] += q[5] > 0.0 ? -base::kPi : base::kPi;
    return q;
  }

  motion::Run runOf(const plan::ToolPlan& plan, const std::vector<JointVector>& joints,
                    std::size_t first, std::size_t last) const {
    motion::Run run;
    for (std::size_t w = first; w <= last; ++w) {
      const Quaterniond tool(cell_.work_T_tool(joints[w]).linear());
      run.points.push_back({{plan.position[w], tool, joints[w], {}},
                            w,
                            w,
                            w > first ? 0.9 : 0.0,
                            plan.speedMmPerS[w]});
    }
    return run;
  }
};

} // namespace

TEST_F(BranchBlend, TheWristChangesAlongThePathWithinTheTolerance) {
  const std::vector<JointVector> joints = arc(base::degreesToRadians(0.8));
  std::vector<JointVector> others;
  for (const JointVector& q : joints)
    others.push_back(otherWrist(q));
  const plan::ToolPlan plan = planOf(cell_, joints);
  ASSERT_LT((planOf(cell_, others).position[7] - plan.position[7]).norm(), 1e-6)
      << "two branches of one pose";
  const collision::GrowingPart part(plan, 1.0, {});
  const motion::MotionScene scene{plan, cell_, collision_, part, options_};
  constexpr std::size_t kMiddle = kPoints / 2;
  const motion::Run before = runOf(plan, joints, 0, kMiddle),
                    after = runOf(plan, others, kMiddle, kPoints - 1);
  const double cone = base::degreesToRadians(3.0);
  const motion::BlendedRun blended = motion::blendBranches(scene, before, after, cone);
  ASSERT_TRUE(blended.run) << static_cast<int>(blended.why);
  const motion::Run& run = *blended.run;
  EXPECT_LT(blended.speedShare, 1.0) << "no joint has to slow the nozzle down";
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
    EXPECT_NEAR(p.at.tip.z(), plan.position[p.next].z(), 1e-5);
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
                                      base::kTwoPi)) < 1e-6);
  // Without tolerance the nozzle cannot follow.
  const motion::BlendedRun strict =
      motion::blendBranches(scene, before, after, base::degreesToRadians(0.2));
  EXPECT_FALSE(strict.run);
  EXPECT_TRUE(strict.why == BlendRefusal::Tilts || strict.why == BlendRefusal::Jumps);
  // Nor with a wrist that is bent too far to be stretched within it.
  const std::vector<JointVector> bent = arc(base::degreesToRadians(30.0));
  std::vector<JointVector> bentOthers;
  for (const JointVector& q : bent)
    bentOthers.push_back(otherWrist(q));
  const plan::ToolPlan bentPlan = planOf(cell_, bent);
  const motion::MotionScene bentScene{bentPlan, cell_, collision_, part, options_};
  EXPECT_FALSE(motion::blendBranches(bentScene, runOf(bentPlan, bent, 0, kMiddle),
                                     runOf(bentPlan, bentOthers, kMiddle, kPoints - 1), cone)
                   .run);
}

TEST_F(BranchBlend, AnArmThatFlipsIsRefused) {
  const std::vector<JointVector> joints = arc(0.02);
  std::vector<JointVector> flipped = joints;
  for (JointVector& q : flipped)
    q.segment<2>(1) += Eigen::Vector2d(1.0, -2.0); // as another branch of the elbow
  const plan::ToolPlan plan = planOf(cell_, joints);
  const collision::GrowingPart part(plan, 1.0, {});
  const motion::MotionScene scene{plan, cell_, collision_, part, options_};
  constexpr std::size_t kMiddle = kPoints / 2;
  const motion::BlendedRun blended = motion::blendBranches(
      scene, runOf(plan, joints, 0, kMiddle), runOf(plan, flipped, kMiddle, kPoints - 1), 0.05);
  EXPECT_FALSE(blended.run);
  EXPECT_EQ(blended.why, BlendRefusal::ArmFlips);
}

TEST_F(BranchBlend, RunsThatDoNotMeetAreRefused) {
  const std::vector<JointVector> joints = arc(0.02);
  const plan::ToolPlan plan = planOf(cell_, joints);
  const collision::GrowingPart part(plan, 1.0, {});
  const motion::MotionScene scene{plan, cell_, collision_, part, options_};
  EXPECT_EQ(
      motion::blendBranches(scene, runOf(plan, joints, 0, 20), runOf(plan, joints, 30, 60), 0.05)
          .why,
      BlendRefusal::Apart);
}

namespace {

// A spiral of three turns in a plane that faces an IRB 2400 so that its wrist, which carries a
// straight nozzle, is nearly stretched: joint 4 turns once per turn of the spiral, by more than its
// range of 400 degrees in all.
class BranchBlendOnASpiral : public testing::Test {
protected:
  process::Process process_ = process::loadProcess("fdm-1.0");
  robot::Cell cell_ = irb2400();
  plan::ToolPlan plan_ = spiral(0.0);

  robot::Cell irb2400() const {
    platform::PlatformSolid plate;
    plate.polygon = test::disc(20.0);
    return robot::loadCell("irb2400-moving", process_, plate);
  }

  // Returns the pose with a stretched wrist and its tip above the plate's middle.
  Eigen::Isometry3d stretched() const {
    JointVector q = cell_.home();
    q[4] = 0.0;
    const auto missing = [&](const JointVector& at) {
      const Vector3d left = Vector3d(0.0, 0.0, 60.0) - cell_.work_T_tool(at).translation();
      return Eigen::Vector2d(left.x(), left.z());
    };
    for (int step = 0; step < 50; ++step) {
      constexpr double kStep = 1e-6;
      Eigen::Matrix2d rates;
      for (Eigen::Index j = 0; j < 2; ++j) {
        JointVector beside = q;
        beside[1 + j] += kStep;
        rates.col(j) = (missing(q) - missing(beside)) / kStep;
      }
      q.segment<2>(1) += rates.partialPivLu().solve(missing(q));
    }
    EXPECT_LT(missing(q).norm(), 1e-6);
    return cell_.work_T_tool(q);
  }

  // `offsetMm`: distance of the stretched pose from the spiral's middle.
  plan::ToolPlan spiral(double offsetMm) const {
    constexpr double kTurns = 3.0, kRadius = 12.0, kPitch = 1.3, kStepMm = 0.8;
    const Eigen::Isometry3d middle = stretched();
    std::vector<Vector3d> points;
    for (double angle = 0.0; angle < kTurns * base::kTwoPi;) {
      const double radius = kRadius + kPitch * angle / base::kTwoPi;
      points.push_back(
          middle * Vector3d(radius * std::cos(angle) + offsetMm, radius * std::sin(angle), 0.0));
      angle += kStepMm / radius;
    }
    plan::ToolPlan plan;
    test::appendPath(plan, points, std::vector<Vector3d>(points.size(), -middle.linear().col(2)),
                     0);
    return plan;
  }

  motion::MotionResult planned(const plan::ToolPlan& plan, bool blends) const {
    const collision::GrowingPart part(plan, 1.0, {});
    motion::MotionOptions options;
    options.blendsBranches = blends;
    return motion::MotionPlanner(plan, cell_, process::Tooling(process_), part, options).plan({});
  }
};

} // namespace

TEST_F(BranchBlendOnASpiral, IsCutWithoutAndPrintedInOnePieceWith) {
  const motion::MotionResult cut = planned(plan_, false), blended = planned(plan_, true);
  EXPECT_EQ(cut.statistics.waypoints, plan_.waypointCount());
  EXPECT_GT(cut.statistics.splits, 0u) << "no branch reaches all waypoints";
  EXPECT_EQ(blended.statistics.splits, 0u);
  EXPECT_EQ(blended.statistics.waypoints, plan_.waypointCount());
  EXPECT_EQ(blended.statistics.collisions, 0u);
  EXPECT_EQ(blended.statistics.unreachable, 0u);
  EXPECT_LT(blended.statistics.transfers, cut.statistics.transfers);

  const plan::Trajectory& t = blended.trajectory;
  double greatest = 0.0;
  std::size_t printed = 0;
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    const std::size_t w = t.waypoint[i];
    if (w == plan::kNoWaypoint || t.move[i] != plan::MoveKind::Print)
      continue;
    ++printed;
    const Eigen::Isometry3d pose =
        cell_.work_T_tool(Eigen::Map<const JointVector>(t.at(i), cell_.dof()));
    EXPECT_LT((pose.translation() - plan_.position[w]).norm(), 1e-3) << w;
    greatest = std::max(
        greatest, std::acos(std::clamp(-pose.linear().col(2).dot(plan_.direction[w]), -1.0, 1.0)));
  }
  EXPECT_EQ(printed, plan_.waypointCount() - 1) << "all but the one where the bead begins";
  EXPECT_LE(greatest, motion::MotionOptions().leanRad + 1e-6);
  EXPECT_GT(greatest, 1e-3) << "the wrist passes its stretched pose";
}

// Programs round directions. Where the wrist is almost stretched, joint 4 follows every
// microradian.
TEST_F(BranchBlendOnASpiral, RoundedDirectionsLeadToTheSameJoints) {
  std::size_t blends = 0;
  for (int k = 0; k < 8; ++k) {
    const plan::ToolPlan plan = spiral(1.1 * k);
    const motion::MotionResult result = planned(plan, true);
    blends += result.statistics.splits == 0;
    const plan::Trajectory& t = result.trajectory;
    std::vector<JointVector> solutions;
    for (std::size_t i = 0; i < t.pointCount(); ++i) {
      if (t.move[i] != plan::MoveKind::Print)
        continue;
      const JointVector q = Eigen::Map<const JointVector>(t.at(i), cell_.dof());
      if (cell_.limits()[3].max - std::abs(q[3]) < 0.05)
        continue; // The rounded pose may be beyond the limit
      Eigen::Isometry3d pose = cell_.work_T_tool(q);
      Quaterniond rounded(pose.linear());
      for (double& part : rounded.coeffs())
        part = 1e-6 * std::round(1e6 * part);
      pose.linear() = rounded.normalized().toRotationMatrix();
      cell_.inverse(pose, q, solutions);
      double nearest = base::kTwoPi;
      for (const JointVector& s : solutions)
        nearest = std::min(nearest, robot::largestRotation(s - q, cell_.robot().limits));
      EXPECT_LT(nearest, 0.05) << "spiral " << k << ", point " << i;
    }
  }
  EXPECT_GT(blends, 0u);
}
