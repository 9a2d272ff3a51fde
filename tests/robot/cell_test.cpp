// The fixed nozzle's frames, joint wrap, and invariants of every row of the tables.
#include "resource_fixture.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "base/units.h"
#include "helpers/temporary_folder.h"
#include "process/process.h"
#include "robot/cell.h"
#include "robot/kinematics/reachable_ball.h"

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

namespace voluta::robot {
namespace {

using base::kPi;

std::vector<Eigen::Vector2d> disc(double diameter) {
  std::vector<Eigen::Vector2d> polygon;
  for (int i = 0; i < 32; ++i)
    polygon.emplace_back(0.5 * diameter * std::cos(2 * kPi * i / 32),
                         0.5 * diameter * std::sin(2 * kPi * i / 32));
  return polygon;
}

class Cells : public test::WithResources {
protected:
  Cell load(const std::string& id) {
    return loadCell(id, process::loadProcess("fdm-1.0"), disc(40));
  }
};

TEST_F(Cells, everyCellKeepsItsContract) {
  ASSERT_FALSE(cellIds().empty());
  for (const std::string& id : cellIds()) {
    const Cell cell = load(id);
    EXPECT_EQ(cell.id(), id);
    EXPECT_EQ(cell.home().size(), cell.dof());
    EXPECT_EQ(static_cast<int>(cell.limits().size()), cell.dof());
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Eigen::Isometry3d> frames;
    std::vector<JointVector> solutions;
    for (int n = 0; n < 500; ++n) {
      JointVector q(cell.dof());
      for (int i = 0; i < cell.dof(); ++i) {
        const JointLimits& l = cell.limits()[static_cast<std::size_t>(i)];
        q[i] = l.min + (l.max - l.min) * unit(random);
      }
      const Eigen::Isometry3d work_T_tool = cell.work_T_tool(q);
      cell.framePoses(q, frames);
      ASSERT_EQ(static_cast<int>(frames.size()),
                cell.armDof() + 4 + static_cast<int>(cell.externalAxes().size()));
      const auto at = [&](int f) { return frames[static_cast<std::size_t>(f)]; };
      EXPECT_TRUE(
          (at(cell.workFrame()).inverse() * at(cell.toolFrame())).isApprox(work_T_tool, 1e-12));
      const Eigen::Isometry3d flange = cell.base_T_flange(work_T_tool, q);
      EXPECT_TRUE(flange.isApprox(at(cell.armDof() + 1), 1e-12));
      EXPECT_TRUE(cell.work_T_toolOfFlange(flange, q).isApprox(work_T_tool, 1e-12));
      cell.inverse(work_T_tool, q, solutions);
      double nearest = 1e9;
      for (const JointVector& s : solutions) {
        EXPECT_TRUE(cell.work_T_tool(s).isApprox(work_T_tool, 1e-9));
        nearest = std::min(nearest, (s - q).cwiseAbs().maxCoeff());
        for (int i = 0; i < cell.dof(); ++i) {
          EXPECT_GE(s[i], cell.limits()[static_cast<std::size_t>(i)].min);
          EXPECT_LE(s[i], cell.limits()[static_cast<std::size_t>(i)].max);
        }
      }
      // The branch q itself is on comes back turned to q, not to q plus whole turns.
      EXPECT_LT(nearest, 1e-5);
    }
  }
}

// The joint vector: the arms' joints, arm by arm, then the external axes.
TEST_F(Cells, everyCellHasOneArmWithItsSliceAndItsHome) {
  const auto same = [](const JointLimits& a, const JointLimits& b) {
    return a.min == b.min && a.max == b.max && a.velocity == b.velocity &&
           a.acceleration == b.acceleration && a.kind == b.kind;
  };
  for (const std::string& id : cellIds()) {
    SCOPED_TRACE(id);
    const Cell cell = load(id);
    EXPECT_EQ(cell.armDof(), cell.robot().dof());
    const std::vector<ExternalAxis>& axes = cell.externalAxes();
    ASSERT_EQ(cell.dof(), cell.armDof() + static_cast<int>(axes.size()));
    for (std::size_t k = 0; k < axes.size(); ++k)
      EXPECT_TRUE(same(cell.limits()[static_cast<std::size_t>(cell.armDof()) + k], axes[k].limits))
          << axes[k].name;
    const JointVector home = cell.home();
    ASSERT_EQ(home.size(), cell.dof());
    for (int i = 0; i < cell.armDof(); ++i) {
      const JointLimits& own = cell.robot().limits[static_cast<std::size_t>(i)];
      EXPECT_TRUE(same(cell.limits()[static_cast<std::size_t>(i)], own)) << i;
      EXPECT_GE(home[i], own.min) << i;
      EXPECT_LE(home[i], own.max) << i;
    }
    EXPECT_EQ(home.tail(cell.dof() - cell.armDof()).norm(), 0.0);
  }
}

TEST_F(Cells, toolPointsDownAndThePlateIsBelowItWhenUpright) {
  const Cell cell = load("ur5-fixed");
  EXPECT_EQ(cell.nozzleMount(), Mount::World);
  Eigen::Isometry3d work_T_tool = Eigen::Isometry3d::Identity();
  work_T_tool.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal(); // extrusion along -z
  std::vector<JointVector> solutions;
  cell.inverse(work_T_tool, cell.home(), solutions);
  ASSERT_FALSE(solutions.empty());
  std::vector<Eigen::Isometry3d> frames;
  for (const JointVector& q : solutions) {
    cell.framePoses(q, frames);
    const Eigen::Isometry3d work = frames[static_cast<std::size_t>(cell.workFrame())];
    const Eigen::Isometry3d tool = frames[static_cast<std::size_t>(cell.toolFrame())];
    const Eigen::Isometry3d flange = frames[static_cast<std::size_t>(cell.dof() + 1)];
    EXPECT_LT((work.linear().col(2) - Eigen::Vector3d::UnitZ()).norm(), 1e-9);
    EXPECT_LT((tool.linear().col(2) + Eigen::Vector3d::UnitZ()).norm(), 1e-9);
    EXPECT_LT((work.translation() - tool.translation()).norm(), 1e-8);
    EXPECT_LT(flange.translation().z(), work.translation().z() - 50.0);
  }
}

// Eq. 2.3 by hand: T_E^B T_P^E T_O^P = T_N^B, numbers of ur5-fixed's file. The nozzle is at (500,
// 0, 500) and points down, the plate's top 100 mm above the flange, the waypoint 30, 40, 25 on it
// with the build direction tilted to y by the angle of 3-4-5. The last is solved for T_E^B.
TEST_F(Cells, flangeOfTheFixedNozzleByHand) {
  const Cell cell = load("ur5-fixed");
  Eigen::Isometry3d work_T_tool = Eigen::Isometry3d::Identity();
  work_T_tool.linear() << 1, 0, 0, 0, -0.8, -0.6, 0, 0.6, -0.8; // its z is -(0, 0.6, 0.8)
  work_T_tool.translation() << 30, 40, 25;
  // base_R_flange = base_R_tool (work_R_tool)^T; its origin: tip - base_R_flange (30, 40, 125).
  Eigen::Matrix4d expected;
  expected << 1, 0, 0, 500 - 30,                 //
      0, 0.8, -0.6, 0 - (0.8 * 40 - 0.6 * 125),  //
      0, 0.6, 0.8, 500 - (0.6 * 40 + 0.8 * 125), //
      0, 0, 0, 1;
  const Eigen::Isometry3d flange = cell.base_T_flange(work_T_tool, cell.home());
  EXPECT_LT((flange.matrix() - expected).cwiseAbs().maxCoeff(), 1e-9);
  std::vector<JointVector> solutions;
  cell.inverse(work_T_tool, cell.home(), solutions);
  ASSERT_FALSE(solutions.empty());
  for (const JointVector& q : solutions)
    EXPECT_LT((cell.robot().kinematics->flange(q).matrix() - expected).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(Cells, bodiesOfTheFixedNozzle) {
  const Cell cell = load("ur5-fixed");
  std::set<std::string> against;
  for (int b : cell.bodiesAgainstPart())
    against.insert(cell.bodies()[static_cast<std::size_t>(b)].name);
  EXPECT_THAT(against, ::testing::IsSupersetOf({"base", "forearm", "wrist 2", "head", "holder"}));
  EXPECT_EQ(against.count("platform"), 0u);
  EXPECT_EQ(against.count("wrist 3"), 0u); // carries the part

  const auto name = [&](int b) { return cell.bodies()[static_cast<std::size_t>(b)].name; };
  std::set<std::pair<std::string, std::string>> pairs;
  for (const auto& [a, b] : cell.checkedPairs()) {
    EXPECT_LT(a, b);
    pairs.insert({name(a), name(b)});
    pairs.insert({name(b), name(a)});
  }
  EXPECT_TRUE(pairs.count({"head", "platform"}));
  EXPECT_TRUE(pairs.count({"head", "wrist 3"}));
  EXPECT_TRUE(pairs.count({"holder", "forearm"}));
  EXPECT_TRUE(pairs.count({"upper arm", "wrist 3"}));
  EXPECT_FALSE(pairs.count({"base", "head"}));        // both are fixed
  EXPECT_FALSE(pairs.count({"wrist 3", "platform"})); // fixed to each other
  EXPECT_FALSE(pairs.count({"forearm", "wrist 1"}));  // neighbours
}

// base_T_work = base_T_root Rx(angle); nothing else of the cell knows the angle.
TEST_F(Cells, workFrameOfTheLatheTurnsAboutItsX) {
  platform::PlatformSolid rod;
  rod.rod = platform::straightRod(5, 200);
  const Cell cell = loadCell("lathe", process::loadProcess("fdm-0.35"), rod);
  ASSERT_EQ(cell.dof(), 7);
  ASSERT_EQ(cell.armDof(), 6);
  ASSERT_EQ(cell.externalAxes().size(), 1u);
  EXPECT_NEAR(cell.externalAxes().front().step, 2 * kPi / 3200, 1e-15);
  std::vector<Eigen::Isometry3d> still, frames;
  cell.framePoses(cell.home(), still);
  const auto at = [](const std::vector<Eigen::Isometry3d>& poses, int f) {
    return poses[static_cast<std::size_t>(f)];
  };
  for (const double angle : {-9.1, -0.7, 0.3, 2.0, 40.0}) {
    JointVector q = cell.home();
    q[6] = angle;
    const double c = std::cos(angle), s = std::sin(angle);
    Eigen::Matrix3d rotation;
    rotation << 1, 0, 0, 0, c, -s, 0, s, c;
    cell.framePoses(q, frames);
    for (int f = 0; f < static_cast<int>(frames.size()); ++f) {
      Eigen::Isometry3d expected = at(still, f);
      if (f == cell.workFrame() || f == cell.axisFrame(0))
        expected.linear() *= rotation;
      EXPECT_TRUE(at(frames, f).isApprox(expected, 1e-12)) << f;
    }
    EXPECT_TRUE(
        cell.base_T_work(q).linear().isApprox(cell.base_T_fixed().linear() * rotation, 1e-12));
    // The tip as seen from the rod, by hand.
    const Eigen::Vector3d tip = at(still, cell.toolFrame()).translation();
    EXPECT_TRUE(cell.work_T_tool(q).translation().isApprox(
        rotation.transpose() * (cell.base_T_fixed().inverse() * tip), 1e-12));
    std::vector<JointVector> solutions;
    cell.inverse(cell.work_T_tool(q), q, solutions);
    ASSERT_FALSE(solutions.empty());
    for (const JointVector& solution : solutions)
      EXPECT_EQ(solution[6], angle);
  }
  // Rod and bearings turn relative to each other, base and bearings do not.
  const auto name = [&](int b) { return cell.bodies()[static_cast<std::size_t>(b)].name; };
  std::set<std::string> against;
  for (const int b : cell.bodiesAgainstPart())
    against.insert(name(b));
  EXPECT_THAT(against, ::testing::IsSupersetOf({"far bearing", "motor", "table", "head", "wrist"}));
  EXPECT_EQ(against.count("platform"), 0u);
  std::set<std::pair<std::string, std::string>> pairs;
  for (const auto& [a, b] : cell.checkedPairs())
    pairs.insert({std::min(name(a), name(b)), std::max(name(a), name(b))});
  EXPECT_TRUE(pairs.count({"forearm", "platform"}));
  EXPECT_TRUE(pairs.count({"head", "motor"}));
  EXPECT_FALSE(pairs.count({"motor", "table"}));
  EXPECT_FALSE(pairs.count({"far bearing", "platform"}));
}

// T = Tz(1020) Rx(q1) Tz(-120) Rz(q2), at (90, 0) in 0, 120, 1020 about x by 90.
TEST_F(Cells, thePositionerTiltsAndTurnsItsPlate) {
  const Cell cell = load("irb1200-irbp");
  ASSERT_EQ(cell.dof(), 8);
  ASSERT_EQ(cell.externalAxes().size(), 2u);
  EXPECT_EQ(cell.externalUnit(), "STN1");
  const Eigen::Isometry3d base_T_stand(Eigen::Translation3d(500, 0, 240 - 1020));
  const auto standing = [&](double tilt, double rotation) {
    JointVector q = cell.home();
    q.tail(2) << base::degreesToRadians(tilt), base::degreesToRadians(rotation);
    return Eigen::Isometry3d(base_T_stand.inverse() * cell.base_T_work(q));
  };
  const Eigen::Isometry3d checked = standing(90, 0);
  EXPECT_LT((checked.translation() - Eigen::Vector3d(0, 120, 1020)).norm(), 1e-9);
  const Eigen::Quaterniond quaternion(checked.linear());
  EXPECT_NEAR(quaternion.w(), 0.7071068, 1e-7);
  EXPECT_NEAR(quaternion.x(), 0.7071068, 1e-7);
  EXPECT_NEAR(quaternion.y(), 0.0, 1e-12);
  EXPECT_NEAR(quaternion.z(), 0.0, 1e-12);
  for (const double tilt : {-130.0, -20.0, 45.0})
    for (const double rotation : {-600.0, 30.0, 410.0}) {
      const Eigen::Isometry3d expected =
          Eigen::Translation3d(0, 0, 1020) *
          Eigen::AngleAxisd(base::degreesToRadians(tilt), Eigen::Vector3d::UnitX()) *
          Eigen::Translation3d(0, 0, -120) *
          Eigen::AngleAxisd(base::degreesToRadians(rotation), Eigen::Vector3d::UnitZ());
      EXPECT_TRUE(standing(tilt, rotation).isApprox(expected, 1e-12));
    }
  // Controllers count from the plate's frame: its z is the last axis.
  EXPECT_TRUE(cell.work_T_unit().isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  // The cradle tilts and does not turn; it may meet the arm and printed beads, not the body it
  // holds.
  const auto name = [&](int b) { return cell.bodies()[static_cast<std::size_t>(b)].name; };
  for (const Body& body : cell.bodies())
    if (body.name == "cradle") {
      EXPECT_EQ(body.frame, cell.axisFrame(0));
    }
  std::set<std::string> against;
  for (const int b : cell.bodiesAgainstPart())
    against.insert(name(b));
  EXPECT_THAT(against, ::testing::IsSupersetOf({"cradle", "stand", "forearm", "head"}));
  EXPECT_EQ(against.count("platform"), 0u);
  std::set<std::pair<std::string, std::string>> pairs;
  for (const auto& [a, b] : cell.checkedPairs())
    pairs.insert({std::min(name(a), name(b)), std::max(name(a), name(b))});
  EXPECT_TRUE(pairs.count({"cradle", "forearm"}));
  EXPECT_TRUE(pairs.count({"cradle", "head"}));
  EXPECT_TRUE(pairs.count({"cradle", "floor"}));
  EXPECT_TRUE(pairs.count({"platform", "stand"}));
  EXPECT_FALSE(pairs.count({"cradle", "platform"}));
  EXPECT_FALSE(pairs.count({"floor", "stand"}));
}

// Inverse, then forward, with external axes anywhere.
TEST_F(Cells, inverseAndForwardAgreeForAnyPositionerPose) {
  const Cell cell = load("irb1200-irbp");
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<JointVector> solutions;
  double worst = 0.0;
  std::size_t found = 0;
  for (int n = 0; n < 2000; ++n) {
    JointVector q(8);
    for (int i = 0; i < 8; ++i) {
      const JointLimits& l = cell.limits()[static_cast<std::size_t>(i)];
      q[i] = l.min + (l.max - l.min) * unit(random);
    }
    const Eigen::Isometry3d work_T_tool = cell.work_T_tool(q);
    cell.inverse(work_T_tool, q, solutions);
    ASSERT_FALSE(solutions.empty());
    found += solutions.size();
    for (const JointVector& s : solutions) {
      EXPECT_EQ(s.tail(2), q.tail(2));
      worst =
          std::max(worst, (cell.work_T_tool(s).translation() - work_T_tool.translation()).norm());
    }
  }
  EXPECT_GE(found, 4000u);
  EXPECT_LE(worst, 1e-8);
}

// A slide between the tilting axis and the plate: mm, along the direction given.
TEST_F(Cells, aSlidingAxisMovesThePlateByMillimetres) {
  nlohmann::json description =
      nlohmann::json::parse(base::readFile(base::resourceFolder() / "cells/irb1200-irbp.json"));
  description["externalAxes"][1] = {{"name", "slide"},
                                    {"kind", "sliding"},
                                    {"pose", {{"xyzMm", {0, 0, -120}}}},
                                    {"axis", {3, 4, 0}},
                                    {"minMm", -50},
                                    {"maxMm", 80},
                                    {"velocityMmPerS", 100},
                                    {"accelerationMmPerS2", 500},
                                    {"stepMm", 0}};
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "irb1200-irbp.json";
  std::ofstream(file) << description.dump();
  const Cell cell = Cell::read(file, process::loadProcess("fdm-1.0"), disc(40));
  EXPECT_EQ(cell.externalAxes()[1].limits.kind, JointKind::Sliding);
  EXPECT_EQ(cell.limits()[7].max, 80.0);
  JointVector q = cell.home();
  q.tail(2) << kPi / 2, 50.0;
  const Eigen::Isometry3d pose = cell.base_T_work(q);
  // In the tilted frame it moves to (30, 40, -120); y of that is up now, and -z to the side.
  EXPECT_LT((pose.translation() - Eigen::Vector3d(530, 120, 280)).norm(), 1e-9);
  EXPECT_TRUE(pose.linear().isApprox(
      Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitX()).toRotationMatrix(), 1e-12));
  std::vector<JointVector> solutions;
  cell.inverse(cell.work_T_tool(q), q, solutions);
  for (const JointVector& s : solutions)
    EXPECT_TRUE(cell.work_T_tool(s).isApprox(cell.work_T_tool(q), 1e-9));
}

TEST_F(Cells, headAndPlatformComeFromProcessAndJob) {
  const Cell cell = load("ur5-fixed");
  for (const Body& body : cell.bodies()) {
    if (body.role == BodyRole::Head) {
      ASSERT_EQ(body.shapes.size(), 3u); // two steps in the section carry no frustum
      const Frustum& tip = std::get<Frustum>(body.shapes.front());
      EXPECT_EQ(tip.p0, Eigen::Vector3d::Zero());
      EXPECT_EQ(tip.p1, Eigen::Vector3d(0, 0, -12));
      EXPECT_EQ(tip.r0, 0.9);
      EXPECT_EQ(tip.r1, 6.0);
      EXPECT_EQ(body.frame, cell.toolFrame());
    }
    if (body.role == BodyRole::Platform) {
      const Prism& plate = std::get<Prism>(body.shapes.front());
      EXPECT_EQ(plate.polygon.size(), 32u);
      EXPECT_EQ(plate.zMax, 0.0);
      EXPECT_LT(plate.zMin, 0.0);
      EXPECT_EQ(body.frame, cell.workFrame());
    }
  }
}

TEST_F(Cells, platformMustBeConvexAndCounterClockwise) {
  const process::Process process = process::loadProcess("fdm-1.0");
  std::vector<Eigen::Vector2d> clockwise = disc(40);
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_THROW(loadCell("ur5-fixed", process, clockwise), base::Error);
  EXPECT_THROW(loadCell("ur5-fixed", process, {{0, 0}, {10, 0}, {2, 2}, {0, 10}}), base::Error);
  EXPECT_THROW(loadCell("ur5-fixed", process, {{0, 0}, {10, 0}}), base::Error);
}

TEST_F(Cells, ballThatFitsIsReachedAndSmallerWithMoreTilt) {
  const Cell cell = load("ur5-fixed");
  const double upright = reachableBallRadius(cell, 0.0);
  const double tilted = reachableBallRadius(cell, base::degreesToRadians(100));
  EXPECT_GE(tilted, 65.0);
  EXPECT_GE(upright, tilted);
  EXPECT_EQ(tilted, reachableBallRadius(cell, base::degreesToRadians(100)));
  // Halving may take one for the largest only because all smaller ones are in reach too.
  for (double radius = 5.0; radius < tilted; radius += 10.0)
    EXPECT_TRUE(reachesBall(cell, base::degreesToRadians(100), radius)) << radius;
  EXPECT_TRUE(reachesBall(cell, base::degreesToRadians(100), tilted));
  EXPECT_FALSE(reachesBall(cell, base::degreesToRadians(100), tilted + 0.25));
  RecordProperty("upright", std::to_string(upright));
  RecordProperty("tilted", std::to_string(tilted));
}

TEST_F(Cells, unknownIdsNameTheNearest) {
  try {
    load("ur5-fixd");
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
    EXPECT_THAT(e.what(), ::testing::HasSubstr("ur5-fixed"));
  }
  EXPECT_THROW(loadRobot("ur6"), base::Error);
}

} // namespace
} // namespace voluta::robot
