// URScript: both forms, times, flow, blends, cuts.
#include "read_programs.h"

#include "program/common/tcp_motions.h"
#include "program/dialect.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <sstream>

namespace voluta::program {
namespace {

class Urscript : public test::ReadPrograms {};

TEST_F(Urscript, isCalledInAFileNodeAndNotOnAPort) {
  appendRandom(2, 50);
  for (const bool port : {false, true}) {
    ProgramInput in = input();
    in.options.own["urscriptForm"] = std::string(port ? "port" : "node");
    const std::string text = writeProgram("urscript", in).files[0].text;
    EXPECT_EQ(text.ends_with("\nend\n"), port);
    EXPECT_EQ(text.ends_with("\nend\nprint_part_1()\n"), !port);
    const plan::ReadProgram back =
        readProgram("urscript", {{"f", text}}, process::Tooling(process_));
    EXPECT_TRUE(back.complete && back.defects.empty());
  }
  const std::string text = writeProgram("urscript", input()).files[0].text;
  EXPECT_FALSE(readProgram("urscript", {{"f", text.substr(0, text.rfind("print_"))}},
                           process::Tooling(process_))
                   .complete);
}

// Motions that print take the plan's time for any law of the controller for turning, and the output
// is written only where the flow leaves its band.
TEST_F(Urscript, givesTimesAndHoldsTheFlow) {
  append(plan::MoveKind::Joint, {0, 0, 0, 0, 0, 0}, 0, 0);
  const double flows[] = {10.0, 10.1, 9.9, 10.15, 9.85, 10.3, 10.4};
  for (int i = 0; i < 7; ++i)
    append(plan::MoveKind::Print, {0.001 * (i + 1), 0, 0, 0, 0.02 * i, 0}, 0.05, 0.05 * flows[i]);
  const std::string text = writeProgram("urscript", input()).files[0].text;
  std::size_t writes = 0;
  for (std::size_t at = 0;
       (at = text.find("set_standard_analog_out(0,0.", at)) != std::string::npos; ++at)
    ++writes;
  EXPECT_EQ(writes, 3u) << text; // the prime, 10, 10.3
  const plan::ReadProgram back = readProgram("urscript", {{"f", text}}, process::Tooling(process_));
  for (std::size_t i = 1; i < back.motions.size(); ++i) {
    EXPECT_NEAR(back.motions[i].durationS, 0.05, 0.05 * kFlowBand);
    EXPECT_NEAR(back.motions[i].durationS * back.motions[i].flowMm3PerS, 0.05 * flows[i - 1], 1e-4);
  }
}

// A plate that turns about its own origin: the TCP rests while the nozzle prints a ring.
TEST_F(Urscript, timesAPlateThatTurnsOnTheSpot) {
  append(plan::MoveKind::Joint, {0, 0, 0, 0, 0, 0}, 0, 0);
  for (int i = 1; i <= 50; ++i)
    append(plan::MoveKind::Print, {0, 0, 0, 0, 0, 0.02 * i}, 0.05, 0.8);
  const plan::ReadProgram back =
      readProgram("urscript", writeProgram("urscript", input()).files, process::Tooling(process_));
  ASSERT_EQ(back.motions.size(), 51u);
  for (std::size_t i = 1; i < back.motions.size(); ++i) {
    EXPECT_NEAR(back.motions[i].durationS, 0.05, 1e-6);
    EXPECT_NEAR(back.motions[i].flowMm3PerS, 16.0, 0.016);
  }
}

TEST_F(Urscript, slowsMotionsThatNeedMoreThanTheFullFlow) {
  append(plan::MoveKind::Joint, {0, 0, 0, 0, 0, 0}, 0, 0);
  append(plan::MoveKind::Print, {0.001, 0, 0, 0, 0, 0}, 0.01, 0.8); // 80 mm3/s, 40 is full
  const plan::ReadProgram back =
      readProgram("urscript", writeProgram("urscript", input()).files, process::Tooling(process_));
  ASSERT_EQ(back.motions.size(), 2u);
  EXPECT_DOUBLE_EQ(back.motions[1].flowMm3PerS, 40.0);
  EXPECT_NEAR(back.motions[1].flowMm3PerS * seconds(back, 1), 0.8, 8e-4);
}

TEST_F(Urscript, isCutOnlyWhereTheExtruderIsOff) {
  appendRandom(9, 1000);
  ProgramInput cut = input();
  cut.options.motionsPerFile = 100;
  const plan::Program program = writeProgram("urscript", cut);
  ASSERT_GT(program.files.size(), 3u);
  const plan::ReadProgram back = readProgram("urscript", program.files, process::Tooling(process_));
  EXPECT_TRUE(back.complete);
  EXPECT_TRUE(back.defects.empty());
  ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
  for (std::size_t i = 1; i < back.motions.size(); ++i) {
    expectTarget(back, i);
    if (back.motions[i].file != back.motions[i - 1].file) {
      EXPECT_FALSE(back.motions[i].extruding);
      EXPECT_EQ(back.motions[i - 1].blendMm, 0.0);
    }
  }
}

TEST_F(Urscript, blendsNeitherMeetNorLeaveAPath) {
  appendRandom(5, 3000);
  const plan::ReadProgram back =
      readProgram("urscript", writeProgram("urscript", input()).files, process::Tooling(process_));
  ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
  std::size_t blended = 0;
  for (std::size_t i = 1; i + 1 < back.motions.size(); ++i) {
    const plan::ProgramMotion& m = back.motions[i];
    const bool inside = trajectory_.move[i] != plan::MoveKind::Joint &&
                        trajectory_.move[i] == trajectory_.move[i + 1];
    if (!inside) {
      EXPECT_EQ(m.blendMm, 0.0);
      continue;
    }
    blended += m.blendMm > 0.0;
    const double next =
        (back.motions[i + 1].frame_T_tcp.translation() - m.frame_T_tcp.translation()).norm();
    EXPECT_LT(m.blendMm + back.motions[i + 1].blendMm, next) << "point " << i;
  }
  EXPECT_GT(blended, 2500u);
}

// The corner as the controller is assumed to round it, run through the cell's own frames: position
// on a parabola, orientation by the same blend of the two turns.
TEST_F(Urscript, blendsStayNearTheCornerOnThePart) {
  for (unsigned seed = 6; seed < 12; ++seed)
    appendRandom(seed, 400);
  const plan::ReadProgram back =
      readProgram("urscript", writeProgram("urscript", input()).files, process::Tooling(process_));
  const auto nozzle = [&](const Eigen::Vector3d& p, const Eigen::Quaterniond& q) {
    Eigen::Isometry3d tcp = Eigen::Isometry3d::Identity();
    tcp.linear() = q.toRotationMatrix();
    tcp.translation() = p;
    return Eigen::Vector3d(
        cell_->work_T_toolOfFlange(tcp * back.flange_T_tcp.inverse(), cell_->home()).translation());
  };
  double worst = 0.0;
  for (std::size_t i = 1; i + 1 < back.motions.size(); ++i) {
    const double r = back.motions[i].blendMm;
    if (r == 0.0)
      continue;
    const Eigen::Isometry3d poses[3] = {tcpAt(i - 1), back.motions[i].frame_T_tcp,
                                        back.motions[i + 1].frame_T_tcp};
    const Eigen::Vector3d c = poses[1].translation();
    const double f1 = r / (c - poses[0].translation()).norm();
    const double f2 = r / (poses[2].translation() - c).norm();
    const Eigen::Quaterniond q0(poses[0].linear()), q1(poses[1].linear()), q2(poses[2].linear());
    // The path without a blend: on the part it is slightly curved.
    std::vector<Eigen::Vector3d> sharp;
    for (int k = -50; k <= 50; ++k) {
      const int side = k < 0 ? 0 : 2;
      const double u = std::abs(k) / 100.0;
      sharp.push_back(
          nozzle(c + u * (poses[side].translation() - c), q1.slerp(u, side == 0 ? q0 : q2)));
    }
    for (int k = 0; k <= 20; ++k) {
      const double s = k / 20.0, a = f1 * (1 - s) * (1 - s), b = f2 * s * s;
      const Eigen::Vector3d p =
          c + a * (poses[0].translation() - c) + b * (poses[2].translation() - c);
      const Eigen::Quaterniond q = q1.slerp(a, q0) * q1.conjugate() * q1.slerp(b, q2);
      const Eigen::Vector3d tip = nozzle(p, q);
      double nearest = 1e9;
      for (std::size_t n = 1; n < sharp.size(); ++n) {
        const Eigen::Vector3d d = sharp[n] - sharp[n - 1], e = tip - sharp[n - 1];
        const double t = std::clamp(e.dot(d) / d.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (e - t * d).norm());
      }
      worst = std::max(worst, nearest);
    }
  }
  // The tolerance holds to first order; the plate's turn within a blend adds its own on these hard
  // random motions. Both together stay a tenth of the tolerance of the replay.
  EXPECT_LE(worst, kBlendToleranceMm + 0.003);
  EXPECT_GT(worst, 0.5 * kBlendToleranceMm);
}

} // namespace
} // namespace voluta::program
