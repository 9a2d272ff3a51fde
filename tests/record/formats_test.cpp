// Records of each format, written from joints of a cell, give the nozzle's tip.
#include "record/formats.h"

#include "base/error.h"
#include "base/units.h"
#include "process/process.h"
#include "program/common/euler_angles.h"
#include "program/common/rotation_vector.h"

#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

namespace voluta::record {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

robot::Cell cellNamed(const std::string& id) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  return robot::loadCell(id, process::loadProcess("fdm-1.0"),
                         {{-60, -60}, {60, -60}, {60, 60}, {-60, 60}});
}

std::vector<robot::JointVector> jointsNear(const robot::Cell& cell, int count) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> step(-0.3, 0.3);
  std::vector<robot::JointVector> all(static_cast<std::size_t>(count), cell.home());
  for (robot::JointVector& q : all)
    for (int k = 0; k < q.size(); ++k)
      q[k] += step(random);
  return all;
}

Isometry3d base_T_tcp(const robot::Cell& cell, const robot::JointVector& q) {
  return cell.base_T_flange(cell.work_T_tool(q), q) * cell.flange_T_moved();
}

void expectTips(const std::string& text, const robot::Cell& cell,
                const std::vector<robot::JointVector>& joints, const std::string& format) {
  const RecordedRun run = readRecord(text, "record.csv", {cell});
  EXPECT_EQ(run.format, format);
  ASSERT_EQ(run.tip.size(), joints.size());
  for (std::size_t i = 0; i < joints.size(); ++i)
    EXPECT_LT((run.tip[i] - cell.work_T_tool(joints[i]).translation()).norm(), 1e-3) << i;
}

TEST(RecordFormats, RtdeJointsGiveTheTip) {
  for (const char* id : {"ur5-fixed", "ur5e-moving"}) {
    const robot::Cell cell = cellNamed(id);
    const auto joints = jointsNear(cell, 50);
    std::string text = "timestamp actual_q_0 actual_q_1 actual_q_2 actual_q_3 actual_q_4 "
                       "actual_q_5 robot_mode\n";
    for (std::size_t i = 0; i < joints.size(); ++i) {
      text += fmt::format("{:.3f}", 8.1 + 0.008 * static_cast<double>(i));
      for (int k = 0; k < 6; ++k)
        text += fmt::format(" {:.9f}", joints[i][k]);
      text += " 7\n";
    }
    expectTips(text, cell, joints, "rtde");
  }
}

TEST(RecordFormats, RtdePosesGiveTheTip) {
  for (const char* id : {"ur5-fixed", "ur5e-moving"}) {
    const robot::Cell cell = cellNamed(id);
    const auto joints = jointsNear(cell, 50);
    std::string text = "timestamp,actual_TCP_pose_0,actual_TCP_pose_1,actual_TCP_pose_2,"
                       "actual_TCP_pose_3,actual_TCP_pose_4,actual_TCP_pose_5\r\n";
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const Isometry3d tcp = base_T_tcp(cell, joints[i]);
      const Vector3d rotation = program::rotationVector(Eigen::Quaterniond(tcp.linear()));
      text += fmt::format("{:.3f},{:.9f},{:.9f},{:.9f},{:.9f},{:.9f},{:.9f}\r\n",
                          0.008 * static_cast<double>(i), 1e-3 * tcp.translation().x(),
                          1e-3 * tcp.translation().y(), 1e-3 * tcp.translation().z(), rotation.x(),
                          rotation.y(), rotation.z());
    }
    expectTips(text, cell, joints, "rtde");
  }
}

TEST(RecordFormats, MelfaPosesGiveTheTip) {
  const robot::Cell cell = cellNamed("rv2f-moving");
  const auto joints = jointsNear(cell, 50);
  std::string text = "time[ms];X;Y;Z;A;B;C\n";
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Isometry3d tcp = base_T_tcp(cell, joints[i]);
    const Vector3d rotation = program::xyzAngles(Eigen::Quaterniond(tcp.linear()));
    text += fmt::format("{:.2f};{:.6f};{:.6f};{:.6f};{:.7f};{:.7f};{:.7f}\n",
                        7.11 * static_cast<double>(i), tcp.translation().x(), tcp.translation().y(),
                        tcp.translation().z(), base::radiansToDegrees(rotation.x()),
                        base::radiansToDegrees(rotation.y()), base::radiansToDegrees(rotation.z()));
  }
  expectTips(text, cell, joints, "melfa");
  EXPECT_NEAR(readRecord(text, "record.csv", {cell}).timeS[1], 0.00711, 1e-12);
}

TEST(RecordFormats, OwnJointTablesGiveTheTip) {
  for (const char* id : {"ur5-fixed", "lathe", "kr10-r1100-slide"}) {
    const robot::Cell cell = cellNamed(id);
    const auto joints = jointsNear(cell, 20);
    std::string text = "# a joint table\ntime_s";
    const auto slides = [&](int k) {
      return cell.limits()[static_cast<std::size_t>(k)].kind == robot::JointKind::Sliding;
    };
    for (int k = 0; k < cell.dof(); ++k)
      text += fmt::format(",j{}_{}", k + 1, slides(k) ? "mm" : "deg");
    text += ",extruded_mm3,waypoint,move\n";
    for (std::size_t i = 0; i < joints.size(); ++i) {
      text += fmt::format("{:.3f}", 0.1 * static_cast<double>(i));
      for (int k = 0; k < cell.dof(); ++k)
        text +=
            fmt::format(",{:.8f}", slides(k) ? joints[i][k] : base::radiansToDegrees(joints[i][k]));
      text += fmt::format(",{:.3f},-1,print\n", 2.0 * static_cast<double>(i));
    }
    text += "# end\n";
    expectTips(text, cell, joints, "joints");
    const RecordedRun run = readRecord(text, "record.csv", {cell});
    ASSERT_EQ(run.extrudedMm3.size(), joints.size());
    EXPECT_DOUBLE_EQ(run.extrudedMm3.back(), 2.0 * 19);
  }
}

TEST(RecordFormats, AnalogueOutputIsAFlow) {
  const robot::Cell cell = cellNamed("ur5-fixed");
  std::string text = "timestamp actual_q_0 actual_q_1 actual_q_2 actual_q_3 actual_q_4 actual_q_5 "
                     "standard_analog_output0\n";
  for (int i = 0; i < 11; ++i)
    text += fmt::format("{} 0 -1.5 1.5 0 0.1 0 2.5\n", 0.1 * i);
  const RecordedRun run = readRecord(text, "r", {cell, 40.0});
  EXPECT_NEAR(run.extrudedMm3.back(), 10.0, 1e-9); // a quarter of 40 mm3/s for one second
  EXPECT_TRUE(readRecord(text, "r", {cell}).extrudedMm3.empty());
}

std::string refusal(const std::string& text, const char* cell = "ur5-fixed") {
  try {
    readRecord(text, "record.csv", {cellNamed(cell)});
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
    return e.what();
  }
  return "taken";
}

TEST(RecordFormats, BadInputIsRefusedInOneLine) {
  const std::string head = "timestamp actual_q_0 actual_q_1 actual_q_2 actual_q_3 actual_q_4 "
                           "actual_q_5\n",
                    row = "0.1 0 0 0 0 0 0\n";
  for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
           {"", "no rows of numbers"},
           {head, "no rows of numbers"},
           {"a b c\n1 2 3\n", "no joints and no pose"},
           {head + row, "fewer than two samples"},
           {head + row + row, "fewer than two samples"},
           {head + row + "1.1 0 0 0 0 0 0\n0.4 0 0 0 0 0 0\n",
            "record.csv, line 4: the time runs backwards, "
            "from 1.000 s to 0.300 s"},
           {head + row + "0.2 0 0\n0.3 0 0 0 0 0 0\n", "line 3"},
           {head + row + "0.2 0 x 0 0 0 0\n", "'actual_q_1'"},
           {"actual_q_0 actual_q_1 actual_q_2 actual_q_3 actual_q_4 actual_q_5\n0 0 0 0 0 0\n",
            "no column of times"},
           {"timestamp actual_q_0\n0 0\n1 0\n", "the cell has 6 axes"},
           {"timestamp actual_TCP_pose_0\n0 0\n1 0\n", "incomplete"}})
    EXPECT_NE(refusal(text).find(why), std::string::npos) << refusal(text);
  EXPECT_NE(refusal("timestamp,X,Y,Z,A,B,C\n0,1,2,3,4,5,6\n1,1,2,3,4,5,6\n", "lathe")
                .find("external axes"),
            std::string::npos);
}

// Samples in another order than they were taken are left out, as repeated ones.
TEST(RecordFormats, SamplesOutOfOrderAreLeftOut) {
  const robot::Cell cell = cellNamed("ur5-fixed");
  const std::string text = "timestamp actual_q_0 actual_q_1 actual_q_2 actual_q_3 actual_q_4 "
                           "actual_q_5\n0 0 0 0 0 0 0\n0.1 0 0 0 0 0 0\n0.092 1 0 0 0 0 0\n"
                           "0.1 1 0 0 0 0 0\n0.2 0 0 0 0 0 0\n";
  EXPECT_EQ(readRecord(text, "r", {cell}).timeS.size(), 3u);
}

TEST(RecordFormats, ARowCutShortAtTheEndIsLeftOut) {
  const robot::Cell cell = cellNamed("ur5-fixed");
  const std::string text = "timestamp actual_q_0 actual_q_1 actual_q_2 actual_q_3 actual_q_4 "
                           "actual_q_5\n0 0 0 0 0 0 0\n0.1 0 0 0 0 0 0\n0.2 0 0";
  EXPECT_EQ(readRecord(text, "r", {cell}).timeS.size(), 2u);
}

} // namespace
} // namespace voluta::record
