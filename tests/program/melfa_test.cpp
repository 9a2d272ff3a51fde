// MELFA-BASIC V: programs of others, cuts, and the meaning of its positions.
#include "program_defects.h"
#include "program_fixture.h"

#include "program/common/euler_angles.h"
#include "program/dialect.h"
#include "program/melfa/melfa.h"

#include <sstream>

namespace voluta::program {
namespace {

using test::expectDefect;
using Melfa = test::Programs;

plan::ReadProgram read(const std::string& text) {
  process::Process process;
  process.maxFlowMm3PerS = 40.0;
  std::string lines;
  for (const char c : text)
    lines += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return readProgram("melfa", {{"A.prg", lines}}, process::Tooling(process));
}

TEST(XyzAngles, AreThoseOfTheReference) {
  const double d = base::kPi / 180.0;
  const Eigen::Quaterniond q(.9515485, .0381346, .1893079, .2392983);
  EXPECT_LT((xyzAngles(q.normalized()) / d - Eigen::Vector3d(10, 20, 30)).norm(), 1e-4);
  EXPECT_LT(rotationOfXyz(Eigen::Vector3d(10, 20, 30) * d).angularDistance(q.normalized()), 1e-6);
  // Near half a turn the angles go on; beyond a right angle of the second too.
  const Eigen::Vector3d beyond = Eigen::Vector3d(170, 100, -185) * d;
  EXPECT_LT(
      (xyzAnglesNear(rotationOfXyz(beyond), beyond + Eigen::Vector3d(.1, .1, .1)) - beyond).norm(),
      1e-9);
  const Eigen::Vector3d upright = Eigen::Vector3d(0, 90, 40) * d;
  EXPECT_LT(
      rotationOfXyz(xyzAngles(rotationOfXyz(upright))).angularDistance(rotationOfXyz(upright)),
      1e-9);
}

// Positions behind the program, labels, subroutines, two statements a line, parts, products.
TEST_F(Melfa, ofOthersIsTakenAsFarAsItIsMotionOutputOrFlow) {
  const plan::ReadProgram program =
      read("10 'a program of somebody's\n20 Def Pos PDrop\n30 tool (0,0,100,0,0,0,0,0)\n"
           "40 M1=50 / 2 ' speed\n50 M_Out(10)=0 : M_Outw(16)=&H0\n60 JOvrd 50\n65 Ovrd 50\n"
           "70 MOV J1\n80 Spd M1*2\n90 *AGAIN\n100 PDrop=P1*(0,0,10,0,0,0)\n"
           "110 Mvs PDrop Wth M_Outw(16)=2500\n120 M_Out(10)=1\n130 PDrop.Z=PDrop.Z+5\n"
           "140 Cnt 1,2,0.5\n150 Mvs PDrop,-10 Type 0,0\n160 Mvs P1+(1,0,0,0,0,0)\n170 Cnt 0\n"
           "180 GoSub *OFF\n190 End\n200 *OFF\n210 M_Out(10)=0\n220 M_Outw(16)=0\n230 Return\n"
           "J1=(0.00,0.00,90.00,0.00,90.00,0.00,0.00,0.00)\n"
           "P1=(+400.00,-20.00,+300.00,+180.00,+0.00,+180.00)(7,0)\n");
  for (const auto& d : program.defects)
    ADD_FAILURE() << d.line << ": " << voluta::base::english(d.reason);
  EXPECT_TRUE(program.complete);
  ASSERT_EQ(program.motions.size(), 4u);
  const auto& m = program.motions;
  EXPECT_EQ(program.flange_T_tcp.translation(), Eigen::Vector3d(0, 0, 100));
  EXPECT_EQ(m[0].target, plan::TargetKind::Joints);
  EXPECT_DOUBLE_EQ(m[0].joints[2], base::kPi / 2);
  EXPECT_DOUBLE_EQ(m[0].jointSpeedRadPerS, 0.25 * kMelfaJointRadPerS);
  // (180, 0, 180) is a half turn about y: its z looks down.
  EXPECT_TRUE(m[1].frame_T_tcp.translation().isApprox(Eigen::Vector3d(400, -20, 290)));
  EXPECT_DOUBLE_EQ(m[1].speedMmPerS, 25.0);
  EXPECT_EQ(m[1].blendMm, 0.0);
  EXPECT_TRUE(m[2].frame_T_tcp.translation().isApprox(Eigen::Vector3d(400, -20, 305)));
  EXPECT_EQ(m[2].blendMm, 0.5);
  EXPECT_EQ(m[2].line, 16u);
  EXPECT_DOUBLE_EQ(m[2].flowMm3PerS, 10.0);
  EXPECT_TRUE(m[3].frame_T_tcp.translation().isApprox(Eigen::Vector3d(401, -20, 300)));
  EXPECT_EQ(m[3].blendMm, 0.0); // Cnt 0 behind it
}

TEST_F(Melfa, namesStatementsThatItCannotRead) {
  const struct {
    const char* line;
    const char* part;
  } cases[] = {
      {"Mvr P1,P1,P1", "not known"},
      {"Mvs ,-50", "not understood"},
      {"Mvs P9", "not understood"},
      {"Mvs J1", "not understood"},
      {"Mvs (1,2,3)", "not a position"},
      {"Mvs (400000,0,0,0,0,0)", "not a position"},
      {"Mvs P1 Type 1,0", "long way"},
      {"Mvs P1 WthIf M_In(1)=1,Skip", "not understood"},
      {"Mvs P1 Wth Dly 1", "without an output"},
      {"EMvs 1,P1", "one program"},
      {"Spd 0", "sensible"},
      {"Ovrd 0.4", "sensible"},
      {"Cnt 2", "'Cnt'"},
      {"Tool (0,0,1,0,0,0)", "different TCP"},
      {"GoTo *A", "not known"},
      {"If M1=1 Then", "not understood"},
      {"GoSub *NOWHERE", "invalid call"},
      {"CallP \"B\"", "is missing"},
      {"M_Out(10)=2", "0 or 1"},
      {"M_Outw(16)=10001", "integer"},
      {"M_Outw(8)=1", "other outputs"},
      {"M_Out(20)=1", "other outputs"},
      {"Def Act 1,M_In(1)=1 GoTo *A", "Def act"},
      {"Open \"COM3:\" As #1", "not known"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    const plan::ReadProgram program =
        read(std::string("1 Tool (0,0,100,0,0,0)\n2 M_Out(10)=0\n3 M_Outw(16)=0\n4 Spd 20\n"
                         "5 Mvs P1\n6 ") +
             c.line + "\n7 M_Out(10)=0\n8 M_Outw(16)=0\n9 End\nP1=(400,0,300,180,0,180)(7,0)\n");
    expectDefect(program, 6, c.part);
  }
  const std::string whole = "1 Tool (0,0,1,0,0,0)\n2 M_Out(10)=0\n3 M_Outw(16)=0\n4 End\n";
  EXPECT_TRUE(read(whole).complete);
  expectDefect(read("1 Tool (0,0,1,0,0,0)\n1 End\n"), 2, "ascend");
  expectDefect(read("32768 End\n"), 1, "32767");
  expectDefect(read("1 '" + std::string(130, 'x') + "\n2 End\n"), 1, "127");
  expectDefect(read("1 Dly 1\n"), 1, "no End");
  EXPECT_TRUE(read("1 M_Out(10)=0\n2 M_Outw(16)=0\n3 End").complete) << "no last line end";
}

// Each program holds no more steps than a controller takes, and has all settings of its own.
TEST_F(Melfa, isCutIntoProgramsThatAreCalledInTurn) {
  appendRandom(9, 1000);
  ProgramInput cut = input();
  cut.name = "a part with a long name";
  cut.options.motionsPerFile = 100;
  const plan::Program program = writeProgram("melfa", cut);
  ASSERT_GT(program.files.size(), 4u);
  EXPECT_EQ(program.files[0].name, "a_part_wi.prg");
  std::vector<std::string> names;
  for (std::size_t f = 1; f < program.files.size(); ++f)
    names.push_back(program.files[f].name);
  EXPECT_EQ(filesOfMelfa(program.files[0].text), names);
  const plan::ReadProgram back = readProgram("melfa", program.files, process::Tooling(process_));
  EXPECT_TRUE(back.complete && back.defects.empty());
  ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
  for (std::size_t i = 1; i < back.motions.size(); ++i)
    if (back.motions[i].file != back.motions[i - 1].file) {
      EXPECT_FALSE(back.motions[i].extruding);
      EXPECT_EQ(back.motions[i - 1].blendMm, 0.0);
    }
  std::vector<plan::ProgramFile> fewer = program.files;
  fewer.pop_back();
  EXPECT_FALSE(readProgram("melfa", fewer, process::Tooling(process_)).complete);
  fewer = program.files;
  fewer[0].text.erase(fewer[0].text.find("_2\"") + 1, 1);
  EXPECT_FALSE(readProgram("melfa", fewer, process::Tooling(process_)).complete);
}

TEST_F(Melfa, stepsAreFewAndShortEnough) {
  appendRandom(9, 30000);
  for (const plan::ProgramFile& file : writeProgram("melfa", input()).files) {
    std::istringstream in(file.text);
    std::size_t steps = 0;
    for (std::string line; std::getline(in, line); ++steps)
      ASSERT_LE(line.size(), kMelfaMaxCharacters + 1) << line;
    EXPECT_LE(steps, kMelfaMaxSteps);
  }
}

// The blends held over several motions are never more than each may have, and less by half at most.
TEST_F(Melfa, heldBlendsAreNeverTooLarge) {
  appendRandom(5, 3000);
  const plan::ReadProgram back =
      readProgram("melfa", writeProgram("melfa", input()).files, process::Tooling(process_));
  ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
  std::size_t blended = 0;
  for (std::size_t i = 2; i + 1 < back.motions.size(); ++i) {
    const auto at = [&](std::size_t k) { return back.motions[k].frame_T_tcp.translation(); };
    const double r = back.motions[i].blendMm;
    EXPECT_LE(r, 0.45 * std::min((at(i) - at(i - 1)).norm(), (at(i + 1) - at(i)).norm()) + 1e-9);
    blended += r > 0.0;
    if (trajectory_.move[i + 1] != trajectory_.move[i]) {
      EXPECT_EQ(r, 0.0);
    }
  }
  EXPECT_GT(blended, 2500u);
}

// The cell's own arm: joints in degrees, structure and turns of its positions.
TEST_F(Melfa, ofItsOwnArmMovesByJoints) {
  useRod(); // an arm with a spherical wrist
  const double d = base::kPi / 180.0;
  append(plan::MoveKind::Joint, {0, 0, 20 * d, 0, 60 * d, 0, 0}, 0, 0);
  append(plan::MoveKind::Joint, {10 * d, 0, 20 * d, 0, -60 * d, 370 * d, 0}, 1, 0);
  append(plan::MoveKind::Linear, {11 * d, 0, 20 * d, 0, -60 * d, 370 * d, 0}, 1, 0);
  ProgramInput in = input();
  const std::string text = writeMelfa(in, {}).files[0].text;
  EXPECT_NE(text.find("J1=(10,0,20,0,-60,370,0)\r\n"), std::string::npos) << text;
  // Axis 5 negative: flipped; axis 6 a turn on.
  EXPECT_NE(text.find(",-60"), std::string::npos);
  EXPECT_NE(text.find(")(6,1048576)\r\n"), std::string::npos) << text;
}

} // namespace
} // namespace voluta::program
