// TMscript: frames, motions by position, velocity and time, and programs of others.
#include "program_defects.h"
#include "program_fixture.h"

#include "program/dialect.h"
#include "program/stream/pvt_velocities.h"
#include "program/tmscript/tmscript.h"
#include "program/tmscript/tmscript_frames.h"

#include <algorithm>
#include <random>

namespace voluta::program {
namespace {

using test::expectDefect;
using Tmscript = test::Programs;

plan::ReadProgram read(const std::string& text) {
  process::Process process;
  process.maxFlowMm3PerS = 40.0;
  return readProgram("tmscript", {{"a.tmscript", text}}, process::Tooling(process));
}

// As the maker's manual and driver have them.
TEST(TmFrames, haveLengthAndChecksum) {
  EXPECT_EQ(tmFrame("1", "ChangeBase(\"RobotBase\")"),
            "$TMSCT,25,1,ChangeBase(\"RobotBase\"),*08\r\n");
  EXPECT_EQ(tmFrame("1", "ScriptExit()"), "$TMSCT,14,1,ScriptExit(),*67\r\n");
  const std::string two = tmFrame("diag", "PVTEnter(1)\r\nPVTExit()");
  const std::string text = two + "// next";
  const TmFrame frame = takeTmFrame(text);
  EXPECT_TRUE(frame.sound);
  EXPECT_EQ(frame.script, "PVTEnter(1)\r\nPVTExit()");
  EXPECT_EQ(frame.length, two.size() - 2);
}

TEST(TmFrames, anyChangeOfAByteIsSeen) {
  const std::string frame = tmFrame("7", "PVTPoint(1,2,3,4,5,6,0,0,0,0,0,0,0.5)");
  for (std::size_t i = 1; i + 2 < frame.size(); ++i)
    for (const char c : {'0', '9', ',', 'x', '*', '\n'}) {
      std::string bad = frame;
      if (bad[i] == c)
        continue;
      bad[i] = c;
      EXPECT_FALSE(takeTmFrame(bad).sound) << bad;
    }
  for (std::size_t length = 1; length + 2 < frame.size(); ++length)
    EXPECT_FALSE(takeTmFrame(frame.substr(0, length)).sound) << length;
  EXPECT_TRUE(takeTmFrame(frame).sound);
}

// A frame that was lost, sent twice or out of turn; the ids of other programs need not be numbers.
TEST(TmFrames, gapsInTheirNumbersAreSeen) {
  const auto gapsOf = [](const std::vector<std::string>& ids) {
    TmFrameNumbers numbers;
    for (std::size_t i = 0; i < ids.size(); ++i)
      numbers.add(ids[i], i + 1);
    std::vector<std::size_t> lines;
    for (const TmFrameGap& gap : numbers.gaps())
      lines.push_back(gap.line);
    return lines;
  };
  using Lines = std::vector<std::size_t>;
  EXPECT_EQ(gapsOf({"1", "2", "3", "x", "5", "6", "99999999999"}), Lines());
  EXPECT_EQ(gapsOf({"1", "2", "3", "5", "6", "7"}), Lines{4});
  EXPECT_EQ(gapsOf({"1", "2", "3", "3", "4", "5"}), Lines{4});
  EXPECT_EQ(gapsOf({"1", "3", "2", "4", "5", "6", "7", "8", "9"}), (Lines{2, 3, 4}));
  EXPECT_EQ(gapsOf({"1", "1", "1", "1"}), Lines());
  EXPECT_EQ(gapsOf({"home", "1", "print", "1"}), Lines());
}

TEST_F(Tmscript, aLostFrameIsFoundAtTheNext) {
  appendRandom(3, 200);
  std::string text = writeProgram("tmscript", input()).files[0].text;
  const std::size_t flow = text.find(",IO[\"ControlBox\"].AO[0]=", text.size() / 2);
  ASSERT_NE(flow, std::string::npos);
  const std::size_t begin = text.rfind('\n', flow) + 1;
  const auto line = static_cast<std::size_t>(std::count(
                        text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n')) +
                    1;
  text.erase(begin, text.find('\n', begin) + 1 - begin);
  expectDefect(read(text), line, "follows frame");
}

// The suitable velocity passes, with the other sign it does not.
TEST(PvtVelocities, ofTheOtherSignLeaveThePath) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int n = 0; n < 200; ++n) {
    PvtMotion in, out;
    in.seconds = 0.05 + 0.1 * std::abs(unit(random));
    out.seconds = 0.05 + 0.1 * std::abs(unit(random));
    in.displacement << 1.0, 0.1 * unit(random), 0.1 * unit(random), 5.0, 0.0, 0.0;
    out.displacement << 1.0, 0.1 * unit(random), 0.1 * unit(random), 5.0, 0.0, 0.0;
    const PvtVector suits = pvtVelocity(in, out, 0.02);
    const PvtFit same = pvtFit(suits, in, out, 0.02), back = pvtFit(-suits, in, out, 0.02);
    EXPECT_TRUE(same.isSpeedSuitable && same.isDirectionSuitable && !same.reverses);
    EXPECT_TRUE(back.isSpeedSuitable && !back.isDirectionSuitable && back.reverses);
    PvtVector turned = suits; // of the angles alone
    turned[3] = -turned[3];
    EXPECT_FALSE(pvtFit(turned, in, out, 0.02).isDirectionSuitable);
    EXPECT_FALSE(pvtFit(PvtVector::Zero(), in, out, 0.02).reverses) << "it may stop";
  }
}

TEST(PvtVelocities, stayNearTheLine) {
  const auto motion = [](double x, double y, double s) {
    PvtMotion m;
    m.displacement[0] = x;
    m.displacement[1] = y;
    m.seconds = s;
    return m;
  };
  // Straight on and evenly: the speed itself, and no deviation.
  const PvtVector even = pvtVelocity(motion(1, 0, 0.1), motion(2, 0, 0.2), 0.02);
  EXPECT_NEAR(even[0], 10.0, 1e-12);
  const PvtDeviation none = pvtDeviation(motion(1, 0, 0.1), even, even);
  EXPECT_NEAR(none.acrossMm + none.alongShare, 0.0, 1e-12);
  // A right angle: as much as the tolerance allows.
  const PvtMotion in = motion(1, 0, 0.1), out = motion(0, 1, 0.1);
  const PvtVector corner = pvtVelocity(in, out, 0.02);
  EXPECT_NEAR(pvtDeviation(in, PvtVector::Zero(), corner).acrossMm, 0.02, 5e-4);
  EXPECT_NEAR(corner[0], corner[1], 1e-12);
  EXPECT_NEAR(corner[0], 0.02 / (4.0 / 27.0 * 0.1), 1e-9);
  // Back again: it stops.
  EXPECT_NEAR(pvtVelocity(motion(1, 0, 0.1), motion(-1, 0, 0.1), 0.02).norm(), 0.0, 1e-12);
  // Nor does a fast motion behind a sharp corner draw a slow one back.
  EXPECT_EQ(pvtVelocity(motion(0.1, 0, 0.1), motion(-4, 0.1, 0.1), 0.02).norm(), 0.0);
  // From rest to rest, 3 u^2 - 2 u^3.
  EXPECT_NEAR(pvtDeviation(in, PvtVector::Zero(), PvtVector::Zero()).alongShare, 0.0962, 1e-3);
}

// Frames of several lines, plain statements, whole-numbered lines, variables and lists.
TEST_F(Tmscript, ofOthersIsTakenAsFarAsItIsMotionOutputOrFlow) {
  const plan::ReadProgram program = read(
      "// by hand\r\n" +
      tmFrame("1", "ChangeTCP({0,0,100,0,0,0},1.5,{0,0,0,0,0,0,0,0,0})\r\n"
                   "IO[\"ControlBox\"].DO[0]=0\r\nIO[\"ControlBox\"].AO[0]=2.5") +
      tmFrame("2", "float[] home = {0,0,90,0,90,0}") +
      tmFrame("3", "PTP(\"JPP\",home,10,200,0,false)") +
      "PTP(\"CPP\",400,0,300,180,0,90,50,200,0,false) // here\r\nQueueTag(1)\r\n"
      "IO[\"ControlBox\"].DO[0]=1\r\n" +
      tmFrame("x", "Line(\"CAP\",{400,10,300,180,0,90},20,200,100,true)") +
      tmFrame("5", "PLine(\"CAR\",400,20,300,180,0,90,20,200,1)") +
      tmFrame("6", "PVTEnter(1)\r\nPVTPoint(400,30,300,180,0,90,0,0,0,0,0,0,0.5)\r\nPVTExit()") +
      tmFrame("7", "IO[\"ControlBox\"].DO[0]=0\r\nIO[\"ControlBox\"].AO[0]=0\r\nScriptExit()"));
  for (const auto& d : program.defects)
    ADD_FAILURE() << d.line << ": " << voluta::base::english(d.reason);
  EXPECT_TRUE(program.complete);
  ASSERT_EQ(program.motions.size(), 5u);
  const auto& m = program.motions;
  EXPECT_EQ(program.load->kg, 1.5);
  EXPECT_EQ(m[0].line, 6u);
  EXPECT_DOUBLE_EQ(m[0].joints[4], base::kPi / 2);
  EXPECT_DOUBLE_EQ(m[0].jointSpeedRadPerS, 0.1 * kTmJointRadPerS); // of the first, always
  EXPECT_DOUBLE_EQ(m[1].jointSpeedRadPerS, 0.5 * kTmJointRadPerS);
  EXPECT_TRUE(m[2].extruding);
  EXPECT_DOUBLE_EQ(m[2].flowMm3PerS, 10.0);
  EXPECT_DOUBLE_EQ(m[2].speedMmPerS, 20.0);
  EXPECT_DOUBLE_EQ(m[2].accelerationMmPerS2, 100.0);
  EXPECT_DOUBLE_EQ(m[2].blendMm, 5.0);
  EXPECT_DOUBLE_EQ(m[3].blendMm, 1.0);
  EXPECT_DOUBLE_EQ(m[4].durationS, 0.5);
  EXPECT_EQ(m[4].line, 13u);
  EXPECT_TRUE(m[4].frame_T_tcp.translation().isApprox(Eigen::Vector3d(400, 30, 300)));
}

TEST_F(Tmscript, namesStatementsThatItCannotRead) {
  const struct {
    const char* line;
    const char* part;
  } cases[] = {
      {"Line(\"CAP\",400,0,300,180,0,90,17.35,200,0,false)", "integers"},
      {"Line(\"CPP\",400,0,300,180,0,90,17,200,0,false)", "percent"},
      {"Line(\"CAP\",400,0,300,180,17,200,0,false)", "letters"},
      {"Circle(\"CAP\",1,2,3,4,5,6,7,8,9,10,11,12,20,200,0,0,false)", "not known"},
      {"PVTPoint(1,2,3,4,5,6,0,0,0,0,0,0,1)", "without PVTEnter"},
      {"PVTEnter(2)", "0 (joints)"},
      {"ChangeTCP(\"NOZZLE\")", "only to the robot"},
      {"ChangeBase(\"table\")", "only to the robot"},
      {"IO[\"ControlBox\"].AO[0]=11", "0 to 10 V"},
      {"IO[\"ControlBox\"].DO[0]=2", "0 or 1"},
      {"while(1)", "not understood"},
      {"repeat(1)", "not known"},
      {"x = y", "not understood"},
      {"$TMSCT,14,1,ScriptExit(),*66", "checksum"},
      {"$TMSCT,15,1,ScriptExit(),*67", "length"},
      {"$TMSTA,2,00,*41", "not a script"},
      {"$TMSCT,x,1,ScriptExit(),*67", "length"},
  };
  const std::string line = tmFrame("1", "Line(\"CAP\",400,0,300,180,0,90,20,200,0,false)");
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    expectDefect(read(tmFrame("1", "ChangeTCP({0,0,100,0,0,0},1)") +
                      tmFrame("1", "IO[\"ControlBox\"].DO[0]=0") +
                      tmFrame("1", "IO[\"ControlBox\"].AO[0]=0") + line + c.line + "\r\n" + line +
                      tmFrame("1", "ScriptExit()")),
                 5, c.part);
  }
  expectDefect(read("ScriptExit()\n"), 1, "CR LF");
  expectDefect(read(tmFrame("1", "QueueTag(1)")), 1, "ScriptExit()");
}

// The joint motion of the cell's own arm, and the place of the prime.
TEST_F(Tmscript, ofItsOwnArmMovesByJoints) {
  append(plan::MoveKind::Joint, {0, 0, 0, 0, 0, 0}, 0, 0);
  append(plan::MoveKind::Joint, {0.5, 0, 0, 0, 0, 1}, 1, 0);
  append(plan::MoveKind::Print, {0.501, 0, 0, 0, 0, 1}, 0.05, 0.1);
  const plan::ReadProgram back =
      readTmscript(writeTmscript(input(), {}).files, process::Tooling(process_), {});
  EXPECT_TRUE(back.complete && back.defects.empty());
  ASSERT_EQ(back.motions.size(), 3u);
  EXPECT_EQ(back.motions[1].target, plan::TargetKind::Joints);
  EXPECT_NEAR(back.motions[1].joints[5], 1.0, 1e-7);
  EXPECT_NEAR(back.motions[1].jointSpeedRadPerS, 1.0, 0.02);
  ASSERT_EQ(back.pauses.size(), 1u);
  EXPECT_EQ(back.pauses[0].before, 1u);
  EXPECT_DOUBLE_EQ(back.pauses[0].durationS, process_.primeS);
}

} // namespace
} // namespace voluta::program
