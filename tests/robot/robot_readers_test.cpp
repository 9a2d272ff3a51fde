// Files with mistakes, pairs left out of the check, and the command line's JSON.
#include "resource_fixture.h"
#include "sampled_distance.h"

#include "base/error.h"
#include "base/units.h"
#include "helpers/all_seeds.h"
#include "helpers/temporary_folder.h"
#include "process/process.h"
#include "robot/cell.h"
#include "robot/cell/robot_json_output.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <random>

namespace voluta::robot {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class Files : public test::WithResources {
protected:
  static json shipped(const std::string& name) {
    return json::parse(std::ifstream(std::string(VOLUTA_SOURCE_DIR "/resources/") + name));
  }
  // The complaint about a shipped file after `damage`; empty when there is none.
  std::string complaint(const std::string& name, const std::function<void(json&)>& damage) {
    json j = shipped(name);
    damage(j);
    const auto file = folder_ / std::filesystem::path(name).filename();
    std::ofstream(file) << j.dump();
    return complaintAbout(file, name.starts_with("cells"));
  }
  std::string complaintAbout(const std::filesystem::path& file, bool isCell) {
    try {
      if (isCell)
        Cell::read(file, process::loadProcess("fdm-1.0"), {{-9, -9}, {9, -9}, {0, 9}});
      else
        readRobot(file);
    } catch (const base::Error& e) {
      EXPECT_TRUE(e.code() == base::ErrorCode::UnusableInput ||
                  e.code() == base::ErrorCode::UnreadableFile);
      EXPECT_THAT(e.what(), HasSubstr(file.filename().string()));
      return e.what();
    }
    return {};
  }

  const test::TemporaryFolder folder_;
};

TEST_F(Files, robotMistakesNameFileAndKey) {
  const std::string ur5 = "robots/ur5.json";
  EXPECT_EQ(complaint(ur5, [](json&) {}), "");
  EXPECT_THAT(complaint(ur5, [](json& j) { j.erase("family"); }), HasSubstr("'family' is missing"));
  EXPECT_THAT(complaint(ur5, [](json& j) { j["family"] = "delta"; }), HasSubstr("'family'"));
  EXPECT_THAT(complaint(ur5, [](json& j) { j["id"] = "ur7"; }), HasSubstr("'id'"));
  EXPECT_THAT(complaint(ur5, [](json& j) { j["geometryMm"]["d4"] = "far"; }),
              HasSubstr("'geometryMm.d4' must be a number"));
  EXPECT_THAT(complaint(ur5, [](json& j) { j["geometryMm"]["a2"] = 0; }),
              HasSubstr("'geometryMm.a2'"));
  EXPECT_THAT(complaint(ur5, [](json& j) { j["limits"][2]["minDeg"] = 200; }),
              HasSubstr("'limits[2]'"));
  EXPECT_THAT(complaint(ur5, [](json& j) { j["limits"][4]["velocityDegPerS"] = 0; }),
              HasSubstr("'limits[4].velocityDegPerS'"));
  EXPECT_THAT(complaint(ur5, [](json& j) { j["limits"].erase(0); }), HasSubstr("'limits'"));
  EXPECT_THAT(complaint(ur5, [](json& j) { j["links"][1]["frame"] = 9; }),
              HasSubstr("'links[1].frame'"));
  EXPECT_THAT(complaint(ur5,
                        [](json& j) {
                          j["links"][1]["shapes"][0]["capsule"]["p0Mm"] = {1, 2};
                        }),
              HasSubstr("'links[1].shapes[0].capsule.p0Mm'"));
  EXPECT_THAT(complaint(ur5, [](json& j) { j["neverMeet"][0]["pair"][0] = "upper leg"; }),
              HasSubstr("did you mean 'upper arm'"));
  EXPECT_THAT(complaint(ur5, [](json& j) { j["lable"] = "x"; }), HasSubstr("'lable'"));
  const std::string t3 = "robots/t3-401s.json";
  EXPECT_EQ(complaint(t3, [](json&) {}), "");
  EXPECT_THAT(complaint(t3, [](json& j) { j["limits"][2]["minDeg"] = -9; }),
              HasSubstr("'limits[2].minDeg'"));
  EXPECT_THAT(complaint(t3, [](json& j) { j["limits"][2]["minMm"] = 200; }),
              HasSubstr("'limits[2]'"));
  EXPECT_THAT(complaint(t3, [](json& j) { j["limits"][2].erase("velocityMmPerS"); }),
              HasSubstr("velocityMmPerS"));
  EXPECT_THAT(complaint(t3, [](json& j) { j["geometryMm"]["a2"] = 0; }),
              HasSubstr("'geometryMm.a2'"));
}

TEST_F(Files, orthoParallelMistakesNameFileAndKey) {
  const std::string irb = "robots/irb1200.json";
  EXPECT_EQ(complaint(irb, [](json&) {}), "");
  EXPECT_THAT(complaint(irb, [](json& j) { j["geometryMm"].erase("b"); }),
              HasSubstr("'geometryMm.b' is missing"));
  EXPECT_THAT(complaint(irb, [](json& j) { j["geometryMm"]["c3"] = 0; }),
              HasSubstr("'geometryMm.c3'"));
  EXPECT_THAT(complaint(irb, [](json& j) { j["geometryMm"]["c2"] = -350; }),
              HasSubstr("'geometryMm.c2'"));
  EXPECT_THAT(complaint(irb, [](json& j) { j["geometryMm"]["d4"] = 1; }), HasSubstr("d4"));
  EXPECT_THAT(complaint(irb, [](json& j) { j["geometryMm"]["offsetsDeg"].erase(0); }),
              HasSubstr("'geometryMm.offsetsDeg' must have 6 joints, has 5"));
  EXPECT_THAT(complaint(irb, [](json& j) { j["geometryMm"]["offsetsDeg"][2] = "down"; }),
              HasSubstr("'geometryMm.offsetsDeg[2]'"));
}

TEST_F(Files, cellMistakesNameFileAndKey) {
  const std::string cell = "cells/ur5-fixed.json";
  EXPECT_EQ(complaint(cell, [](json&) {}), "");
  EXPECT_THAT(complaint(cell, [](json& j) { j["robot"] = "ur55"; }), HasSubstr("'robot'"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["nozzle"]["mount"] = "wall"; }),
              HasSubstr("'nozzle.mount'"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["platform"]["mount"] = "world"; }),
              HasSubstr("'platform.mount'"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["platform"]["thicknessMm"] = -5; }),
              HasSubstr("'platform.thicknessMm'"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["platform"]["pose"]["xyzMm"][0] = 1e200; }),
              HasSubstr("must be within a kilometre"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["homeDeg"][2] = 181; }), HasSubstr("'homeDeg[2]'"));
  const auto travels = [&](double value) {
    return complaint(cell, [&](json& j) { j["travelAccelerationDegPerS2"] = value; });
  };
  EXPECT_EQ(travels(800.0), "");
  EXPECT_THAT(travels(801.0), HasSubstr("'travelAccelerationDegPerS2' exceeds"));
  EXPECT_THAT(travels(0.0), HasSubstr("'travelAccelerationDegPerS2'"));
  const json axis = json::parse(R"({"name": "rail", "kind": "turning", "axis": [1, 0, 0],
      "pose": {"xyzMm": [0, 0, 0]}, "minDeg": -9, "maxDeg": 9, "stepDeg": 0,
      "velocityDegPerS": 1, "accelerationDegPerS2": 1, "end": "unwinds"})");
  EXPECT_THAT(complaint(cell, [&](json& j) { j["externalAxes"] = json::array({axis}); }),
              HasSubstr("'externalAxes' must be empty: the plate is on the flange"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["obstacles"][0]["name"] = "forearm"; }),
              HasSubstr("'obstacles[0].name'"));
}

TEST_F(Files, mistakesAboutAxesNameFileAndKey) {
  const std::string cell = "cells/irb1200-irbp.json";
  EXPECT_EQ(complaint(cell, [](json&) {}), "");
  const auto axis = [&](int k, const char* key, const json& value) {
    return complaint(cell, [&](json& j) { j["externalAxes"][k][key] = value; });
  };
  EXPECT_THAT(axis(0, "carries", "floor"),
              HasSubstr("'externalAxes[0].carries' must be platform or robot, is 'floor'"));
  EXPECT_THAT(axis(1, "carries", "robot"),
              HasSubstr("'externalAxes[1].carries' must be platform after an axis"));
  EXPECT_EQ(axis(0, "carries", "robot"), "");
  EXPECT_EQ(axis(0, "carries", "platform"), "");
  EXPECT_THAT(axis(0, "kind", "rolling"), HasSubstr("'externalAxes[0].kind' must be turning or"));
  EXPECT_THAT(axis(0, "kind", "sliding"),
              HasSubstr("'externalAxes[0].accelerationDegPerS2' (did you mean"));
  EXPECT_THAT(axis(1, "axis", {0, 0, 0}), HasSubstr("'externalAxes[1].axis' must not be zero"));
  EXPECT_THAT(axis(1, "pose", {0, 0, 0}), HasSubstr("'externalAxes[1].pose'"));
  EXPECT_THAT(
      complaint(cell, [](json& j) { j["externalAxes"][0]["bodies"][0]["name"] = "forearm"; }),
      HasSubstr("already used: 'forearm'"));
  EXPECT_THAT(
      complaint(cell, [](json& j) { j["externalAxes"].push_back(j["externalAxes"][1]); }),
      HasSubstr("'externalAxes' too many: robot and external axes together may have 8 axes"));
}

TEST_F(Files, mistakesAboutTheRodNameFileAndKey) {
  const std::string cell = "cells/lathe.json";
  EXPECT_EQ(complaint(cell, [](json&) {}), "");
  const auto axis = [&](const char* key, const json& value) {
    return complaint(cell, [&](json& j) { j["externalAxes"][0][key] = value; });
  };
  EXPECT_THAT(axis("end", "spins"), HasSubstr("'externalAxes[0].end' must be unwinds or runsOn"));
  EXPECT_THAT(axis("stepDeg", -1), HasSubstr("'externalAxes[0].stepDeg'"));
  EXPECT_THAT(axis("velocityDegPerS", 0), HasSubstr("'externalAxes[0].velocityDegPerS'"));
  EXPECT_THAT(axis("minDeg", 10), HasSubstr("'externalAxes[0]' must include the home position 0"));
  EXPECT_THAT(axis("minDeg", "low"), HasSubstr("'externalAxes[0].minDeg' must be a number"));
  EXPECT_THAT(axis("speed", 1), HasSubstr("'externalAxes[0].speed'"));
  EXPECT_THAT(axis("axis", {0, 1, 0}), HasSubstr("must turn the rod about its own axis"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["externalAxes"].clear(); }),
              HasSubstr("'externalAxes' must have exactly one axis"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["externalAxes"][0] = 1; }),
              HasSubstr("'externalAxes[0]' must be an object"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["externalAxes"] = "rod"; }),
              HasSubstr("'externalAxes'"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["platform"]["rod"]["printableRadiusMm"] = 2; }),
              HasSubstr("'platform.rod.printableRadiusMm'"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["platform"]["rod"]["diameterMm"] = 0; }),
              HasSubstr("'platform.rod.diameterMm'"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["platform"]["thicknessMm"] = 5; }),
              HasSubstr("'platform.thicknessMm'"));
  EXPECT_THAT(complaint(cell, [](json& j) { j["homeDeg"].push_back(0); }),
              HasSubstr("'homeDeg' must have 6 joints, has 7"));
  EXPECT_THAT(complaint(cell,
                        [](json& j) {
                          j["platform"]["mount"] = "flange";
                          j["nozzle"]["mount"] = "world";
                        }),
              HasSubstr("'platform.mount' must be world"));
}

TEST_F(Files, notJsonOrNotThere) {
  const auto file = folder_ / "ur5.json";
  EXPECT_NE(complaintAbout(file, false), "");
  std::ofstream(file) << "{\"id\": \"ur5\", ";
  EXPECT_THAT(complaintAbout(file, false), HasSubstr("not JSON"));
  std::ofstream(file) << "[1, 2]";
  EXPECT_NE(complaintAbout(file, false), "");
}

// Bodies whose axes come close can't be left out of the check; only fat enclosures may overlap.
TEST_F(Files, linksThatNeverMeetKeepTheirAxesApart) {
  for (const std::string& id : robotIds()) {
    const RobotModel robot = loadRobot(id);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Eigen::Isometry3d> poses;
    for (const auto& [a, b] : robot.neverMeet) {
      const Body &first = robot.links[static_cast<std::size_t>(a)],
                 &second = robot.links[static_cast<std::size_t>(b)];
      Body axis = second;
      for (Shape& shape : axis.shapes)
        std::get<Capsule>(shape).radius = 0.0;
      std::vector<test::Sample> samples = test::samplesOf(first, 15.0);
      for (test::Sample& s : samples)
        s.radius = 0.0;
      double minimum = 1e9;
      for (int n = 0; n < test::ofSeeds(2000, 20000); ++n) {
        JointVector q(robot.dof());
        for (int i = 0; i < robot.dof(); ++i) {
          const JointLimits& limit = robot.limits[static_cast<std::size_t>(i)];
          q[i] = limit.min + unit(random) * (limit.max - limit.min);
        }
        robot.kinematics->linkPoses(q, poses);
        minimum = std::min(minimum, test::sampledDistance(
                                        samples, poses[static_cast<std::size_t>(first.frame)], axis,
                                        poses[static_cast<std::size_t>(second.frame)], -1.0));
      }
      EXPECT_GT(minimum, 40.0) << id << ": " << first.name << " and " << second.name;
    }
  }
}

TEST_F(Files, homeIsClearOfEverything) {
  std::vector<Eigen::Vector2d> square{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};
  for (const std::string& id : cellIds()) {
    const Cell cell = loadCell(id, process::loadProcess("fdm-1.0"), square);
    std::vector<Eigen::Isometry3d> frames;
    cell.framePoses(cell.home(), frames);
    const auto pose = [&](const Body& b) { return frames[static_cast<std::size_t>(b.frame)]; };
    for (const auto& [i, j] : cell.checkedPairs()) {
      const Body &a = cell.bodies()[static_cast<std::size_t>(i)],
                 &b = cell.bodies()[static_cast<std::size_t>(j)];
      EXPECT_GT(test::sampledDistance(test::samplesOf(a, 5), pose(a), b, pose(b), 0.0), 5.0)
          << id << ": " << a.name << " and " << b.name;
    }
  }
}

TEST_F(Files, jsonForwardAndBack) {
  const RobotModel robot = loadRobot("ur5");
  const std::vector<double> joints{10, -80, 70, -60, -90, 30};
  const json pose = json::parse(forwardJson(robot, joints));
  std::vector<double> values;
  for (double v : pose.at("positionMm"))
    values.push_back(v);
  for (double v : pose.at("quaternion"))
    values.push_back(v);
  ASSERT_EQ(values.size(), 7u);
  const json back = json::parse(inverseJson(robot, values)).at("solutions");
  double nearest = 1e9;
  for (const json& s : back) {
    double worst = 0.0;
    for (std::size_t i = 0; i < 6; ++i)
      worst = std::max(worst, std::abs(s.at(i).get<double>() - joints[i]));
    nearest = std::min(nearest, worst);
  }
  EXPECT_LT(nearest, 1e-9);
  EXPECT_EQ(inverseJson(robot, {5000, 0, 0, 1, 0, 0, 0}), "{\"solutions\":[]}");
  EXPECT_THROW(forwardJson(robot, {1, 2, 3}), base::Error);
  EXPECT_THROW(inverseJson(robot, {1, 2, 3, 0, 0, 0, 0}), base::Error);
  EXPECT_THROW(inverseJson(robot, {1, 2, NAN, 1, 0, 0, 0}), base::Error);
}

} // namespace
} // namespace voluta::robot
