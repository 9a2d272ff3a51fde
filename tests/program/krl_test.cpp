// KRL as it is written, and as other people write it.
#include "program_defects.h"
#include "program_fixture.h"

#include "base/units.h"
#include "program/common/euler_angles.h"
#include "program/common/language_words.h"
#include "program/dialect.h"
#include "program/krl/krl.h"

#include <algorithm>

namespace voluta::program {
namespace {

using test::expectDefect;

plan::ReadProgram readFiles(std::vector<plan::ProgramFile> files) {
  process::Process process;
  process.maxFlowMm3PerS = 40.0;
  return readProgram("krl", files, process::Tooling(process));
}

// In lines 10 and on.
std::string around(const std::string& body) {
  return "&ACCESS RVP\n&REL 1\nDEF part ( )\nBAS (#INITMOV,0 )\n"
         "$BASE={X 100,Y 0,Z 0,A 90,B 0,C 0}\n$TOOL={X 0,Y 0,Z 120,A 0,B 0,C 0}\n"
         "$OUT[1]=FALSE\n$ANOUT[1]=0.25\n$VEL.CP=0.02\n" +
         body + "$OUT[1]=FALSE\n$ANOUT[1]=0\nEND\n";
}
plan::ReadProgram read(const std::string& body) {
  return readFiles({{"part.src", around(body)}});
}
void expectSound(const plan::ReadProgram& program) {
  EXPECT_TRUE(program.complete);
  for (const auto& d : program.defects)
    ADD_FAILURE() << d.file << ":" << d.line << ": " << voluta::base::english(d.reason);
}

// R = Rz(30) Ry(20) Rx(10), docs/programs.md.
TEST(EulerAngles, areTheMakersConvention) {
  const Eigen::Quaterniond q(.9515485, .0381346, .1893079, .2392983);
  EXPECT_TRUE(zyxDegrees(q).isApprox(Eigen::Vector3d(30, 20, 10), 1e-6));
  EXPECT_LT(rotationOfZyx({30, 20, 10}).angularDistance(q), 1e-6);
  for (const double b : {90.0, -90.0}) {
    const Eigen::Quaterniond up = rotationOfZyx({40, b, 25});
    EXPECT_LT(rotationOfZyx(zyxDegrees(up)).angularDistance(up), 1e-7);
  }
}

TEST(KrlReader, takesTheConventions) {
  const auto program = read("PTP {A1 0,A2 -90,A3 90,A4 0,A5 90,A6 0}\n"
                            "LIN {X 10,Y 0,Z 5,A 30,B 20,C 10}\n");
  expectSound(program);
  ASSERT_EQ(program.motions.size(), 2u);
  EXPECT_EQ(program.motions[0].target, plan::TargetKind::Joints);
  EXPECT_NEAR(program.motions[0].joints[1], -0.5 * base::kPi, 1e-12);
  const Eigen::Isometry3d& pose = program.motions[1].frame_T_tcp;
  // In a base that is rotated by 90 degrees at x 100.
  EXPECT_TRUE(pose.translation().isApprox(Eigen::Vector3d(100, 10, 5), 1e-9));
  const Eigen::Quaterniond rotation(.9515485, .0381346, .1893079, .2392983);
  EXPECT_LT(
      Eigen::Quaterniond(pose.linear())
          .angularDistance(Eigen::AngleAxisd(0.5 * base::kPi, Eigen::Vector3d::UnitZ()) * rotation),
      1e-6);
  EXPECT_DOUBLE_EQ(program.motions[1].speedMmPerS, 20.0);
  EXPECT_NEAR(program.flange_T_tcp.translation().z(), 120.0, 1e-12);
}

// As other posts and people write it.
TEST(KrlReader, takesVariablesPartialTargetsAndCallsAcrossFiles) {
  const std::string main =
      "&ACCESS RVP\r\n&REL 7\r\n&PARAM TEMPLATE = C:\\KRC\\Roboter\r\n&COMMENT mine\r\n"
      "DEF Job( )\r\nDECL E6POS P1\r\nDECL REAL fast = 0.1, share\r\nSIGNAL extruder $OUT[1]\r\n"
      ";FOLD INI;%{PE}\r\n  GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )\r\n"
      "  INTERRUPT ON 3\r\n  BAS (#INITMOV,0 )\r\n;ENDFOLD (INI)\r\n"
      "$BWDSTART = FALSE\r\nPDAT_ACT = PDEFAULT\r\nFDAT_ACT = {TOOL_NO 1,BASE_NO 0,IPO_FRAME "
      "#BASE}\r\n"
      "TOOL_DATA[1]={X 0,Y 0,Z 50,A 0,B 0,C 0}\r\nBAS(#TOOL,1)\r\nBAS(#BASE,0)\r\n"
      "$VEL.CP=2*fast/10\r\n$APO.CDIS = 0.5\r\nBAS(#VEL_PTP,20)\r\n"
      "P1={E6POS: X 10,Y 20,Z 30,A 0,B 90,C 0,S 'B010',T 2,E1 0.0,E2 0.0}\r\n"
      "extruder = FALSE\r\n$ANOUT[1]=0.5\r\nPTP HOME\r\nptp P1\r\n"
      "P1.Z = P1.Z - 0.5\r\nLIN P1\r\nextruder=TRUE\r\nshare=0.4\r\n"
      "layer ( )\r\nEND\r\n";
  const std::string layer = "DEF layer ( )\r\nLIN {X 11} C_DIS\r\n"
                            "TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]=share\r\n"
                            "SLIN {X 12} WITH $VEL.CP=0.05, $APO={CDIS 0.2} C_DIS\r\n"
                            "LIN {X 13,Y 21} ; the last\r\n$OUT[1]=FALSE\r\n$ANOUT[1]=0\r\nEND\r\n";
  const std::string data = "&ACCESS RVP\r\nDEFDAT JOB PUBLIC\r\nDECL E6AXIS HOME={A1 0,A2 -90,A3 "
                           "90,A4 0,A5 0,A6 0,E1 0}\r\nENDDAT\r\n";
  const auto program = readFiles({{"Job.src", main}, {"Job.dat", data}, {"layer.src", layer}});
  expectSound(program);
  ASSERT_EQ(program.motions.size(), 6u);
  const auto& m = program.motions;
  EXPECT_NEAR(m[0].jointSpeedRadPerS, base::degreesToRadians(36.0), 1e-9);
  EXPECT_TRUE(m[1].jointInterpolated && m[1].target == plan::TargetKind::FlangePose);
  EXPECT_TRUE(m[2].frame_T_tcp.translation().isApprox(Eigen::Vector3d(10, 20, 29.5), 1e-9));
  EXPECT_TRUE(m[3].frame_T_tcp.translation().isApprox(Eigen::Vector3d(11, 20, 29.5), 1e-9));
  EXPECT_TRUE(m[3].frame_T_tcp.linear().isApprox(m[1].frame_T_tcp.linear(), 1e-9));
  EXPECT_EQ(m[3].file, 2u);
  EXPECT_EQ(m[3].line, 2u);
  EXPECT_DOUBLE_EQ(m[3].blendMm, 0.5);
  EXPECT_DOUBLE_EQ(m[3].flowMm3PerS, 20.0);
  EXPECT_DOUBLE_EQ(m[4].speedMmPerS, 50.0);
  EXPECT_DOUBLE_EQ(m[4].blendMm, 0.2);
  EXPECT_DOUBLE_EQ(m[4].flowMm3PerS, 16.0);
  EXPECT_DOUBLE_EQ(m[5].speedMmPerS, 20.0);
  EXPECT_TRUE(m[5].extruding);
  EXPECT_EQ(filesOfKrl(main), std::vector<std::string>{"layer.src"});
}

// The slower of way and turn.
TEST(KrlReader, turnsMayRule) {
  const auto program = read("PTP {X 0,Y 0,Z 0,A 0,B 0,C 0}\n$VEL.ORI1=30\n$VEL.ORI2=60\n"
                            "LIN {X 1,A 15}\nLIN {X 31,A 30}\n");
  expectSound(program);
  EXPECT_NEAR(program.motions[1].durationS, 0.5, 1e-9);
  EXPECT_EQ(program.motions[2].durationS, 0.0);
  EXPECT_DOUBLE_EQ(program.motions[2].speedMmPerS, 20.0);
}

TEST(KrlReader, anOutputBetweenMotionsHaltsTheArm) {
  const std::string head = "$APO.CDIS=0.3\nPTP {X 0,Y 0,Z 0,A 0,B 0,C 0}\n";
  const auto stays = read(head + "LIN {X 10} C_DIS\nTRIGGER WHEN DISTANCE=0 DELAY=0 DO "
                                 "$ANOUT[1]=0.5\nLIN {X 20}\n");
  const auto halts = read(head + "LIN {X 10} C_DIS\n$ANOUT[1]=0.5\nLIN {X 20}\n");
  const auto never = read("$ADVANCE=0\n" + head + "LIN {X 10} C_DIS\nLIN {X 20}\n");
  for (const auto& program : {stays, halts, never})
    expectSound(program);
  EXPECT_DOUBLE_EQ(stays.motions[1].blendMm, 0.3);
  EXPECT_EQ(halts.motions[1].blendMm, 0.0);
  EXPECT_EQ(never.motions[1].blendMm, 0.0);
}

TEST(KrlReader, namesStatementsThatItCannotRead) {
  const std::string move = "PTP {X 0,Y 0,Z 0,A 0,B 0,C 0}\n";
  const struct {
    const char* line;
    const char* part;
  } cases[] = {{"CIRC {X 1},{X 2}\n", "not known"},
               {"SPLINE\n", "not known"},
               {"LIN_REL {X 1}\n", "not known"},
               {"LIN {X 1,Q 2}\n LIN nowhere\n", "not understood"},
               {"LIN {X 1,X 2}\n", "not understood"},
               {"LIN {X 1 Y 2}\n", "not understood"},
               {"LIN {X 400000}\n", "reach"},
               {"LIN {A1 0,A2 0,A3 0,A4 0,A5 0,A6 0}\n", "straight"},
               {"PTP {A1 0,A2 0}\n", "not all axes"},
               {"LIN {X 1} C_VEL\n", "c_vel"},
               {"LIN {X 1} C_DIS\n", "$APO.CDIS"},
               {"PTP {X 1} C_PTP\n", "c_ptp"},
               {"LIN {X 1,E1 5}\nLIN {X 2,E1 6}\n", "external"},
               {"CONTINUE\n$OUT[1]=TRUE\n", "ahead"},
               {"TRIGGER WHEN DISTANCE=1 DELAY=0 DO $OUT[1]=TRUE\n", "start of a motion"},
               {"TRIGGER WHEN PATH=5 DELAY=0 DO $OUT[1]=TRUE\n", "not understood"},
               {"$OV_PRO=50\n", "slows"},
               {"$ORI_TYPE=#CONSTANT\n", "evenly"},
               {"$TOOL=TOOL_DATA[3]\n", "not understood"},
               {"BAS (#BASE,2)\n", "only the controller"},
               {"$ANOUT[1]=1.5\n", "0..1"},
               {"speed=5\n", "not known"},
               {"other ( )\n", "is missing"},
               {"part ( )\n", "calls itself"},
               {"WAIT SEC -1\n", "seconds"},
               {"FOR i=1 TO 5\n", "not known"},
               {"IF TRUE THEN\n", "not known"}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    const std::string two = c.line;
    const bool second = std::count(two.begin(), two.end(), '\n') == 2;
    expectDefect(read(move + two + "LIN {X 5}\n"), second ? 12 : 11, c.part);
  }
  expectDefect(readFiles({{"a.src", "DEF a ( )\nPTP {X 0,Y 0,Z 0,A 0,B 0,C 0}\nEND\n"}}), 2,
               "$BASE");
  EXPECT_FALSE(readFiles({{"a.src", "DEF a ( )\n"}}).complete);
  EXPECT_FALSE(readFiles({{"a.src", around("")}, {"a.dat", "DEFDAT a\n"}}).complete);
  expectDefect(readFiles({{"a.src", around("")}, {"b.src", "DEF b ( )\nHALT\nEND\n"}}), 1,
               "no procedure of this file");
}

using Krl = test::Programs;

TEST_F(Krl, aFixedNozzleIsTheBaseAndThePartTheTool) {
  appendRandom(4, 60);
  const plan::Program program = writeProgram("krl", input());
  const std::string& text = program.files[0].text;
  EXPECT_NE(text.find("$IPO_MODE=#TCP\r\n$BASE={X -800,Y -250,Z 0,A 0,B 0,C 180}\r\n"
                      "$TOOL={X 0,Y 0,Z 100,A 0,B 0,C 0}\r\n"),
            std::string::npos)
      << text.substr(0, 2000);
  const plan::ReadProgram back = readProgram("krl", program.files, process::Tooling(process_));
  expectSound(back);
  ASSERT_TRUE(back.base_T_nozzle && back.base_T_nozzle->isApprox(cell_->base_T_fixed(), 1e-6));
  EXPECT_EQ(program.files[1].text,
            "&ACCESS RVP\r\n&REL 1\r\nDEFDAT print_part_1 PUBLIC\r\nENDDAT\r\n");
}

TEST_F(Krl, aRodIsE1) {
  useRod();
  appendRandomOnRod(5, 60);
  const std::string text = writeProgram("krl", input()).files[0].text;
  EXPECT_NE(text.find("$IPO_MODE=#BASE\r\n$BASE=EK(MACHINE_DEF[2].ROOT,MACHINE_DEF[2].MECH_TYPE,{X "
                      "0,Y 0,Z 0,A "),
            std::string::npos)
      << text.substr(0, 2000);
  const plan::ReadProgram back = readProgram("krl", {{"f", text}}, process::Tooling(process_));
  for (std::size_t i = 0; i < back.motions.size(); ++i) {
    EXPECT_EQ(back.motions[i].target, plan::TargetKind::UnitPose);
    EXPECT_NEAR(back.motions[i].externals.at(0), trajectory_.at(i)[6], 1e-6);
  }
}

TEST_F(Krl, longProgramsAreCalledFileByFile) {
  appendRandom(9, 1000);
  ProgramInput cut = input();
  cut.options.motionsPerFile = 100;
  cut.options.own["krlMemoryMb"] = 0.05;
  cut.name = "a part with a long name";
  const plan::Program program = writeProgram("krl", cut);
  ASSERT_GT(program.files.size(), 8u);
  const plan::ReadProgram back = readProgram("krl", program.files, process::Tooling(process_));
  expectSound(back);
  ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
  for (std::size_t i = 1; i < back.motions.size(); ++i)
    if (back.motions[i].file != back.motions[i - 1].file) {
      EXPECT_FALSE(back.motions[i].extruding);
      EXPECT_EQ(back.motions[i - 1].blendMm, 0.0);
    }
  const std::string& main = program.files[0].text;
  EXPECT_NE(main.find("; TOO LONG: 0.2 MB of programs, the controller has room for 0.05 MB"),
            std::string::npos)
      << main;
  std::size_t known = 0;
  for (const std::string& name : filesOfKrl(main))
    known += std::any_of(program.files.begin(), program.files.end(),
                         [&](const auto& f) { return f.name == name; });
  EXPECT_EQ(known, program.files.size() - 2); // all but main and its data
  for (const plan::ProgramFile& file : program.files) {
    const std::string name = file.name.substr(0, file.name.size() - 4);
    EXPECT_LE(name.size(), 24u);
    EXPECT_NE(file.text.find(" " + name + " "), std::string::npos) << file.text.substr(0, 80);
  }
  std::vector<plan::ProgramFile> fewer = program.files;
  fewer.pop_back();
  EXPECT_FALSE(readProgram("krl", fewer, process::Tooling(process_)).complete);
  EXPECT_FALSE(readProgram("krl", fewer, process::Tooling(process_)).defects.empty());
}

// A motion that turns on the spot is timed by its turn, and the limit is high again after it.
TEST_F(Krl, turnsOnTheSpotAreTimed) {
  append(plan::MoveKind::Joint, {0, 0, 0, 0, 0, 0}, 0, 0);
  append(plan::MoveKind::Print, {0.01, 0, 0, 0, 0, 0}, 0.3, 1.0);
  const Eigen::Isometry3d here = cell_->work_T_tool(Eigen::VectorXd::Map(trajectory_.at(1), 6));
  std::vector<robot::JointVector> found;
  Eigen::Isometry3d turned = here;
  turned.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
  const Eigen::Map<const Eigen::VectorXd> near(trajectory_.at(1), 6);
  cell_->inverse(turned, near, found);
  ASSERT_FALSE(found.empty());
  const robot::JointVector& q =
      *std::min_element(found.begin(), found.end(), [&](const auto& a, const auto& b) {
        return (a - near).norm() < (b - near).norm();
      });
  append(plan::MoveKind::Print, {q.data(), q.data() + 6}, 0.4, 0.8);
  const plan::ReadProgram back =
      readProgram("krl", writeProgram("krl", input()).files, process::Tooling(process_));
  expectSound(back);
  EXPECT_NEAR(back.motions[2].durationS, 0.4, 0.4 * 0.02);
  EXPECT_NEAR(back.motions[2].durationS * back.motions[2].flowMm3PerS, 0.8, 1e-3);
}

TEST(KrlWords, areTheLanguagesOwn) {
  for (const char* word : {"lin", "PTP", "end", "TRIGGER", "pos", "halt"})
    EXPECT_TRUE(isKrlWord(word)) << word;
  for (const char* name : {"print_part", "x", ""})
    EXPECT_FALSE(isKrlWord(name));
  EXPECT_LE(krlName("a part whose name is far longer than this").size(), 19u);
}

} // namespace
} // namespace voluta::program
