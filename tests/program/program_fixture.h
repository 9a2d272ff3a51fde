// A cell and trajectories to write programs from.
#pragma once

#include "base/files.h"
#include "base/units.h"
#include "helpers/temporary_folder.h"
#include "process/process.h"
#include "program/dialect.h"
#include "program/program_input.h"
#include "robot/cell.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <optional>
#include <random>
#include <string>

namespace voluta::test {

// A UR5 with round numbers, so that the expected texts don't follow the shipped cell's tuning.
inline constexpr const char* kCellJson = R"({
  "id": "bench", "label": "bench", "robot": "ur5",
  "nozzle": {"mount": "world", "pose": {"xyzMm": [-800, -250, 0], "rpyDeg": [180, 0, 0]},
             "holder": [{"frustum": {"p0Mm": [0, 0, -110], "p1Mm": [0, 0, -600],
                                     "r0Mm": 20, "r1Mm": 20}}]},
  "platform": {"mount": "flange", "pose": {"xyzMm": [0, 0, 100]}, "thicknessMm": 5,
               "stem": [{"frustum": {"p0Mm": [0, 0, -92], "p1Mm": [0, 0, -5],
                                     "r0Mm": 14, "r1Mm": 14}}]},
  "obstacles": [], "homeDeg": [0, 0, 0, 0, 0, 0], "neverMeet": [], "externalAxes": []
})";

// An IRB 1200 whose nozzle moves over a rod that is across in front of it.
inline constexpr const char* kRodCellJson = R"({
  "id": "bench", "label": "bench", "robot": "irb1200",
  "nozzle": {"mount": "flange", "pose": {"xyzMm": [0, 0, 200]}},
  "platform": {"mount": "world", "pose": {"xyzMm": [0, 0, 0]},
               "rod": {"diameterMm": 5, "lengthMm": 200, "printableRadiusMm": 50}},
  "obstacles": [], "homeDeg": [0, 0, 0, 0, 0, 0], "neverMeet": [],
  "externalAxes": [{"name": "rod", "kind": "turning", "axis": [1, 0, 0],
                    "pose": {"xyzMm": [400, 0, 350], "rpyDeg": [0, 0, 90]}, "minDeg": -360000, "maxDeg": 360000, "velocityDegPerS": 720,
                    "accelerationDegPerS2": 8400, "stepDeg": 0.1125, "end": "runsOn"}]
})";

class Programs : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
    process_ = process::loadProcess("fdm-1.0");
    const TemporaryFolder folder;
    base::writeFile(folder / "bench.json", kCellJson);
    cell_.emplace(robot::Cell::read(folder / "bench.json", process_,
                                    {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}));
  }

  // An arm whose joints the dialect can state; the bench's own where it can.
  void useArmFor(const program::Dialect& dialect) {
    std::string json = kCellJson;
    if (dialect.needsJoints && dialect.controller == "melfa")
      json.replace(json.find("\"ur5\""), 5, "\"rv2f\"");
    const TemporaryFolder folder;
    base::writeFile(folder / "bench.json", json);
    cell_.emplace(robot::Cell::read(folder / "bench.json", process_,
                                    {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}));
  }

  void useRod() {
    const TemporaryFolder folder;
    base::writeFile(folder / "bench.json", kRodCellJson);
    cell_.emplace(robot::Cell::read(folder / "bench.json", process_, {}));
  }

  void usePositioner() {
    platform::PlatformSolid plate;
    plate.polygon = {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
    cell_.emplace(robot::loadCell("irb1200-irbp", process_, plate));
  }

  void append(plan::MoveKind move, const std::vector<double>& q, double seconds, double volume) {
    plan::Trajectory& t = trajectory_;
    const bool first = t.timeS.empty();
    t.dof = static_cast<int>(q.size());
    t.joints.insert(t.joints.end(), q.begin(), q.end());
    t.timeS.push_back(first ? 0.0 : t.timeS.back() + seconds);
    t.extrudedMm3.push_back(first ? 0.0 : t.extrudedMm3.back() + volume);
    t.move.push_back(move);
    t.waypoint.push_back(plan::kNoWaypoint);
  }

  // Paths of Print points with travels between them, joints wandering at random.
  void appendRandom(unsigned seed, std::size_t points) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<double> q = {0.1, -1.9, 1.7, -1.2, -1.4, 0.3}, drift(6);
    append(plan::MoveKind::Joint, q, 1.0, 0.0);
    std::size_t waypoint = plan_.waypointCount();
    for (std::size_t i = 1; i < points; ++i) {
      const std::size_t phase = i % 40; // a travel of three points, then a path
      if (phase == 1)
        for (double& d : drift)
          d = 4e-3 * (unit(random) - 0.5);
      for (std::size_t k = 0; k < 6; ++k)
        q[k] += phase < 3 ? 0.05 * (unit(random) - 0.5) : drift[k] + 1e-3 * (unit(random) - 0.5);
      const double volume = phase < 3 || phase == 39 ? 0.0 : 0.05 + unit(random);
      const auto move = phase == 1                 ? plan::MoveKind::Joint
                        : phase < 3 || phase == 39 ? plan::MoveKind::Linear
                                                   : plan::MoveKind::Print;
      append(move, q, volume / 30.0 + 0.01 + 0.1 * unit(random), volume);
      if (move == plan::MoveKind::Print || phase == 2)
        noteWaypoint(waypoint++, phase == 2, static_cast<int>(i / 400));
    }
    plan_.position.assign(waypoint, Eigen::Vector3d::Zero());
    plan_.direction.assign(waypoint, Eigen::Vector3d::UnitZ());
  }

  // The same with the nozzle along the plate's normal where it does not move by joints.
  void appendRandomUpright(unsigned seed, std::size_t points) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Eigen::Vector3d tip(0, 0, 5), drift = Eigen::Vector3d::Zero();
    double yaw = 0.3;
    robot::JointVector q(6);
    q << 0.1, -1.9, 1.7, -1.2, -1.4, 0.3;
    std::vector<robot::JointVector> solutions;
    std::size_t waypoint = plan_.waypointCount();
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t phase = i % 40;
      const auto any = [&](double maximum) {
        return Eigen::Vector3d(maximum * (unit(random) - 0.5), maximum * (unit(random) - 0.5),
                               maximum * (unit(random) - 0.5));
      };
      if (phase == 1)
        drift = any(1.0);
      tip += phase < 3 ? any(8.0) - 0.05 * (tip - Eigen::Vector3d(0, 0, 5))
                       : Eigen::Vector3d(drift + any(0.2));
      yaw += 0.01 * (unit(random) - 0.5);
      Eigen::Isometry3d work_T_tool = Eigen::Isometry3d::Identity();
      work_T_tool.linear() = (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                              Eigen::AngleAxisd(base::kPi, Eigen::Vector3d::UnitX()))
                                 .toRotationMatrix();
      work_T_tool.translation() = tip;
      solutions.clear();
      cell_->inverse(work_T_tool, q, solutions);
      ASSERT_FALSE(solutions.empty());
      q = robot::JointVector(
          *std::min_element(solutions.begin(), solutions.end(), [&](const auto& a, const auto& b) {
            return (a - q).squaredNorm() < (b - q).squaredNorm();
          }));
      const double volume = phase < 3 || phase == 39 ? 0.0 : 0.05 + unit(random);
      const auto move = phase < 2                   ? plan::MoveKind::Joint
                        : phase == 2 || phase == 39 ? plan::MoveKind::Linear
                                                    : plan::MoveKind::Print;
      append(move, std::vector<double>(q.data(), q.data() + 6),
             volume / 30.0 + 0.01 + 0.1 * unit(random), volume);
      if (move == plan::MoveKind::Print || phase == 2)
        noteWaypoint(waypoint++, phase == 2, static_cast<int>(i / 400));
    }
    plan_.position.assign(waypoint, Eigen::Vector3d::Zero());
    plan_.direction.assign(waypoint, Eigen::Vector3d::UnitZ());
  }

  // A trajectory that this dialect can write, in place of the current one.
  void randomFor(const program::Dialect& dialect, unsigned seed, std::size_t points) {
    trajectory_ = {};
    plan_ = {};
    useArmFor(dialect);
    if (dialect.tiltsNozzle) {
      appendRandom(seed, points);
      return;
    }
    // The nozzle nearer, so that the arm reaches a level plate below it.
    std::string near = kCellJson;
    near.replace(near.find("-800, -250, 0"), 13, "-500, -200, 200");
    const TemporaryFolder folder;
    base::writeFile(folder / "bench.json", near);
    cell_.emplace(robot::Cell::read(folder / "bench.json", process_,
                                    {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}));
    appendRandomUpright(seed, points);
  }

  // The last point is this waypoint of the plan, the first of a path or one more of the last.
  void noteWaypoint(std::size_t waypoint, bool startsPath, int layer) {
    if (startsPath)
      plan_.paths.push_back({.first = waypoint, .count = 0, .layer = layer});
    ++plan_.paths.back().count;
    trajectory_.waypoint.back() = waypoint;
  }

  // Likewise on the rod, which turns by whole steps and turn after turn.
  void appendRandomOnRod(unsigned seed, std::size_t points) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<double> q = {0.1, -0.1, 0.3, 0.1, 1.2, 0.3, 0.0}, drift(6);
    const double step = cell_->externalAxes().front().step;
    double steps = 0.0;
    std::size_t waypoint = plan_.waypointCount();
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t phase = i % 40;
      if (phase == 1)
        for (double& d : drift)
          d = 2e-4 * (unit(random) - 0.5);
      for (std::size_t k = 0; k < 6; ++k)
        q[k] += phase < 3 ? 0.02 * (unit(random) - 0.5) : drift[k] + 1e-4 * (unit(random) - 0.5);
      steps += std::round(60.0 * unit(random));
      q[6] = step * steps;
      const double volume = phase < 3 || phase == 39 ? 0.0 : 0.05 + 0.2 * unit(random);
      const auto move = phase < 2                   ? plan::MoveKind::Joint
                        : phase == 2 || phase == 39 ? plan::MoveKind::Linear
                                                    : plan::MoveKind::Print;
      append(move, q, volume / 30.0 + 0.05 + 0.1 * unit(random), volume);
      if (move == plan::MoveKind::Print || phase == 2)
        noteWaypoint(waypoint++, phase == 2, static_cast<int>(i / 400));
    }
    plan_.position.assign(waypoint, Eigen::Vector3d::Zero());
    plan_.direction.assign(waypoint, Eigen::Vector3d::UnitX());
  }

  // Likewise on a plate that tilts and turns meanwhile.
  void appendRandomOnPositioner(unsigned seed, std::size_t points) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<double> q = {0.1, -0.1, 0.3, 0.1, 1.2, 0.3, 0.2, -3.0}, drift(8);
    std::size_t waypoint = plan_.waypointCount();
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t phase = i % 40;
      if (phase == 1)
        for (double& d : drift)
          d = 4e-4 * (unit(random) - 0.5);
      for (std::size_t k = 0; k < 8; ++k)
        q[k] += phase < 3 ? 0.02 * (unit(random) - 0.5) : drift[k] + 1e-4 * (unit(random) - 0.5);
      const double volume = phase < 3 || phase == 39 ? 0.0 : 0.05 + 0.2 * unit(random);
      const auto move = phase < 2                   ? plan::MoveKind::Joint
                        : phase == 2 || phase == 39 ? plan::MoveKind::Linear
                                                    : plan::MoveKind::Print;
      append(move, q, volume / 30.0 + 0.05 + 0.1 * unit(random), volume);
      if (move == plan::MoveKind::Print || phase == 2)
        noteWaypoint(waypoint++, phase == 2, static_cast<int>(i / 400));
    }
    plan_.position.assign(waypoint, Eigen::Vector3d::Zero());
    plan_.direction.assign(waypoint, Eigen::Vector3d::UnitZ());
  }

  // Beads that turn about the plate's normal at random, with travels between them.
  void appendTurning(unsigned seed, int beads) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<double> q = {0.1, -1.9, 1.7, -1.2, -1.4, 0.0};
    append(plan::MoveKind::Joint, q, 1.0, 0.0);
    std::size_t waypoint = 0;
    for (int b = 0; b < beads; ++b) {
      for (int i = 0; i < 3; ++i) { // away, over, down
        q[5] += 0.01;
        append(plan::MoveKind::Linear, q, 0.1, 0.0);
      }
      noteWaypoint(waypoint++, true, b);
      const double angle = 0.2 * (unit(random) + 0.5);
      for (int i = 0; i < 40; ++i) {
        q[5] += angle;
        append(plan::MoveKind::Print, q, 0.1, 0.3);
        noteWaypoint(waypoint++, false, b);
      }
    }
    plan_.position.assign(waypoint, Eigen::Vector3d::Zero());
    plan_.direction.assign(waypoint, Eigen::Vector3d::UnitZ());
  }
  program::ProgramInput input() const {
    return {plan_, trajectory_, *cell_, process::Tooling(process_), "part 1"};
  }

  process::Process process_;
  std::optional<robot::Cell> cell_;
  plan::ToolPlan plan_;
  plan::Trajectory trajectory_;
};

} // namespace voluta::test
