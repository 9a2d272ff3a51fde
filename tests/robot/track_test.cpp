// Axes that carry the robot: the cell "kr10-r1100-track" and chains made of it.
#include "resource_fixture.h"

#include "base/files.h"
#include "base/units.h"
#include "process/process.h"
#include "robot/cell.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

namespace voluta::robot {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;
using nlohmann::json;

constexpr const char* kId = "kr10-r1100-track";

platform::PlatformSolid square() {
  platform::PlatformSolid solid;
  solid.polygon = {{-40, -40}, {40, -40}, {40, 40}, {-40, 40}};
  return solid;
}

class Track : public test::WithResources {
protected:
  static json own() {
    return json::parse(
        base::readFile(base::resourceFolder() / "cells" / (std::string(kId) + ".json")));
  }
  static Cell read(const json& description) {
    return Cell::readText(description.dump(), std::string(kId) + ".json",
                          process::loadProcess("fdm-1.0"), square());
  }
  static json slide(const char* name, const char* carries, const std::vector<double>& at,
                    const std::vector<double>& along) {
    return {{"name", name},          {"kind", "sliding"},
            {"carries", carries},    {"pose", {{"xyzMm", at}}},
            {"axis", along},         {"minMm", -500},
            {"maxMm", 500},          {"stepMm", 0},
            {"velocityMmPerS", 500}, {"accelerationMmPerS2", 1000}};
  }
  static json rotary(const char* name, const char* carries, const std::vector<double>& at,
                     const std::vector<double>& about) {
    return {{"name", name},          {"kind", "turning"},
            {"carries", carries},    {"pose", {{"xyzMm", at}}},
            {"axis", about},         {"minDeg", -180},
            {"maxDeg", 180},         {"stepDeg", 0},
            {"velocityDegPerS", 90}, {"accelerationDegPerS2", 300},
            {"end", "unwinds"}};
  }
  static JointVector anywhere(const Cell& cell, std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    JointVector q(cell.dof());
    for (int i = 0; i < cell.dof(); ++i) {
      const JointLimits& l = cell.limits()[static_cast<std::size_t>(i)];
      q[i] = l.min + (l.max - l.min) * unit(random);
    }
    return q;
  }
  static std::string nameOf(const Cell& cell, int body) {
    return cell.bodies()[static_cast<std::size_t>(body)].name;
  }
};

// The arm moves 300 mm along y: the plate and all fixed bodies move back relative to it.
TEST_F(Track, movesTheArmPastFixedBodies) {
  const Cell cell = read(own());
  ASSERT_EQ(cell.dof(), 7);
  EXPECT_EQ(cell.axesUnderRobot(), 1u);
  EXPECT_FALSE(cell.axesMovePlatform());
  EXPECT_EQ(cell.robotUnit(), "TRACK");
  JointVector q = cell.home();
  const Isometry3d rest = cell.base_T_work(q);
  EXPECT_TRUE(cell.base_T_world(q).isApprox(Isometry3d::Identity(), 1e-15));
  EXPECT_TRUE(rest.isApprox(cell.base_T_fixed(), 1e-15));
  q[6] = 300.0;
  EXPECT_TRUE(cell.base_T_world(q).isApprox(Isometry3d(Translation3d(0, -300, 0)), 1e-12));
  EXPECT_TRUE(cell.base_T_work(q).isApprox(Translation3d(0, -300, 0) * rest, 1e-12));
  EXPECT_LT((cell.work_T_tool(q).translation() -
             (cell.work_T_tool(cell.home()).translation() + Vector3d(0, 300, 0)))
                .norm(),
            1e-9);
  std::vector<Isometry3d> frames;
  cell.framePoses(q, frames);
  const Isometry3d world_T_base = frames[static_cast<std::size_t>(cell.worldFrame())].inverse();
  EXPECT_TRUE(world_T_base.isApprox(Isometry3d(Translation3d(0, 300, 0)), 1e-12));
  for (const Body& body : cell.bodies())
    if (body.role == BodyRole::Obstacle) {
      EXPECT_EQ(body.frame, body.name == "carriage" ? 0 : cell.worldFrame()) << body.name;
    }
}

TEST_F(Track, fixedBodiesAreCheckedAgainstTheCarriage) {
  const Cell cell = read(own());
  std::set<std::pair<std::string, std::string>> pairs;
  for (const auto& [a, b] : cell.checkedPairs())
    pairs.insert(
        {std::min(nameOf(cell, a), nameOf(cell, b)), std::max(nameOf(cell, a), nameOf(cell, b))});
  EXPECT_TRUE(pairs.count({"carriage", "table"}));
  EXPECT_TRUE(pairs.count({"carriage", "platform"}));
  EXPECT_TRUE(pairs.count({"base", "platform"}));
  EXPECT_TRUE(pairs.count({"base", "table"}));
  EXPECT_TRUE(pairs.count({"forearm", "carriage"}) || pairs.count({"carriage", "forearm"}));
  EXPECT_FALSE(pairs.count({"base", "carriage"}));
  EXPECT_FALSE(pairs.count({"carriage", "track"}));
  EXPECT_FALSE(pairs.count({"platform", "table"}));
  EXPECT_FALSE(pairs.count({"floor", "track"}));
  std::set<std::string> against;
  for (const int b : cell.bodiesAgainstPart())
    against.insert(nameOf(cell, b));
  EXPECT_THAT(against, ::testing::IsSupersetOf({"carriage", "base", "forearm", "head"}));
  EXPECT_EQ(against.count("table"), 0u);
  EXPECT_EQ(against.count("platform"), 0u);
}

// A rail in the world, a lift on it under the robot, a table that turns: as poses multiplied out by
// hand, from the world.
TEST_F(Track, aChainUnderTheRobotAndOneUnderThePlate) {
  json description = own();
  description["externalAxes"] = {slide("lift", "robot", {10, 20, -30}, {0, 0, 1}),
                                 rotary("table", "platform", {750, 40, 100}, {0, 0, 1})};
  description["neverMeet"] = json::array();
  description["platform"]["pose"] = {{"xyzMm", {0, 15, 50}}};
  const Cell cell = read(description);
  ASSERT_EQ(cell.dof(), 8);
  EXPECT_EQ(cell.axesUnderRobot(), 1u);
  EXPECT_TRUE(cell.axesMovePlatform());
  EXPECT_EQ(cell.externalUnit(), "TRACK");
  EXPECT_EQ(cell.robotUnit(), "lift");
  std::mt19937_64 random(5);
  for (int n = 0; n < 200; ++n) {
    const JointVector q = anywhere(cell, random);
    const Isometry3d world_T_base(Translation3d(0, 0, q[6]));
    const Isometry3d world_T_work = Translation3d(750, 40, 100) *
                                    AngleAxisd(q[7], Vector3d::UnitZ()) * Translation3d(0, 15, 50);
    EXPECT_TRUE(cell.base_T_world(q).isApprox(world_T_base.inverse(), 1e-12));
    const Isometry3d tool = world_T_work.inverse() * world_T_base *
                            cell.robot().kinematics->flange(q) * cell.flange_T_moved();
    EXPECT_TRUE(cell.work_T_tool(q).isApprox(tool, 1e-12));
  }
}

// Two axes under the robot, the one right under it first: a rail carries a column that turns.
TEST_F(Track, axisRightUnderTheRobotComesFirst) {
  json description = own();
  description["externalAxes"] = {rotary("column", "robot", {-200, 30, -100}, {0, 0, -2}),
                                 slide("rail", "robot", {5, 5, -300}, {3, 4, 0})};
  description["externalAxes"][1]["bodies"] = {
      {{"name", "saddle"},
       {"shapes", {{{"box", {{"pose", {{"xyzMm", {0, 0, 20}}}}, {"sizeMm", {50, 50, 10}}}}}}}}};
  description["neverMeet"] = json::array();
  const Cell cell = read(description);
  EXPECT_EQ(cell.axesUnderRobot(), 2u);
  std::mt19937_64 random(6);
  std::vector<Isometry3d> frames;
  std::vector<JointVector> solutions;
  std::size_t found = 0;
  for (int n = 0; n < 500; ++n) {
    const JointVector q = anywhere(cell, random);
    const Isometry3d rail(Translation3d(0.6 * q[7], 0.8 * q[7], 0));
    const Isometry3d column = Translation3d(-200, 30, 0) * AngleAxisd(-q[6], Vector3d::UnitZ()) *
                              Translation3d(200, -30, 0);
    const Isometry3d world_T_base = rail * column;
    EXPECT_TRUE(cell.base_T_world(q).isApprox(world_T_base.inverse(), 1e-12));
    const Isometry3d wanted = cell.work_T_tool(q);
    EXPECT_TRUE(
        (cell.base_T_fixed() * wanted)
            .isApprox(world_T_base * cell.robot().kinematics->flange(q) * cell.flange_T_moved(),
                      1e-12));
    cell.framePoses(q, frames);
    for (const Body& body : cell.bodies())
      if (body.name == "saddle") { // moves with the rail, and does not turn with the column
        const Box& box = std::get<Box>(body.shapes.front());
        const Isometry3d world_T_box =
            world_T_base * frames[static_cast<std::size_t>(body.frame)] * box.frame_T_box;
        EXPECT_TRUE(world_T_box.isApprox(rail * Translation3d(5, 5, -280), 1e-12));
      }
    cell.inverse(wanted, q, solutions);
    ASSERT_FALSE(solutions.empty());
    found += solutions.size();
    for (const JointVector& s : solutions) {
      EXPECT_EQ(s.tail(2), q.tail(2));
      EXPECT_LE((cell.work_T_tool(s).translation() - wanted.translation()).norm(), 1e-8);
    }
  }
  EXPECT_GE(found, 1000u);
}

// A slide turns nothing: an arm that keeps its nozzle upright does so on a track too.
TEST_F(Track, tiltsNoMoreThanTheArm) {
  const auto tilts = [](const char* cell, const json& axis) {
    json description = json::parse(
        base::readFile(base::resourceFolder() / "cells" / (std::string(cell) + ".json")));
    description["externalAxes"] = json::array({axis});
    description["neverMeet"] = json::array();
    return Cell::readText(description.dump(), std::string(cell) + ".json",
                          process::loadProcess("fdm-1.0"), square())
        .tilts();
  };
  EXPECT_FALSE(tilts("t3", slide("rail", "robot", {0, 0, 0}, {0, 1, 0})));
  EXPECT_TRUE(tilts("t3", rotary("tilt", "platform", {0, 0, 0}, {1, 0, 0})));
  EXPECT_TRUE(tilts(kId, slide("rail", "robot", {0, 0, 0}, {0, 1, 0})));
}

} // namespace
} // namespace voluta::robot
