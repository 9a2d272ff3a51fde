// SPEL+ as it is written, and as other people write it.
#include "program_defects.h"
#include "program_fixture.h"

#include "base/units.h"
#include "program/common/language_words.h"
#include "program/dialect.h"
#include "program/spel/spelplus.h"

#include <algorithm>

namespace voluta::program {
namespace {

using test::expectDefect;

plan::ReadProgram readFiles(std::vector<plan::ProgramFile> files) {
  process::Process process;
  process.maxFlowMm3PerS = 40.0;
  return readProgram("spel", files, process::Tooling(process));
}

// In lines 8 and on.
std::string around(const std::string& body) {
  return "Function part\n  Motor On\n  Power High\n  TLSet 1, XY(0,0,120,0,0,0)\n  Tool 1\n"
         "  Speed 5; SpeedS 20; AccelS 500\n  Off 1; AIO_Out 1, 2.5\n" +
         body + "  Off 1\n  AIO_Out 1, 0\nFend\n";
}
plan::ReadProgram read(const std::string& body) {
  return readFiles({{"part.prg", around(body)}});
}
void expectSound(const plan::ReadProgram& program) {
  EXPECT_TRUE(program.complete);
  for (const auto& d : program.defects)
    ADD_FAILURE() << d.file << ":" << d.line << ": " << voluta::base::english(d.reason);
}

TEST(SpelplusReader, takesTheConventions) {
  const auto program = read("Go AglToPls(0,-30,20,0,90,0)\nMove XY(300,10,200,30,20,10)\n"
                            "Local 2, XY(100,0,0,90,0,0)\nMove XY(10,0,5,0,0,0) /2 CP\n"
                            "Move XY(10,0,6,0,0,0) /2\n");
  expectSound(program);
  ASSERT_EQ(program.motions.size(), 4u);
  const auto& m = program.motions;
  EXPECT_NEAR(m[0].joints[1], base::degreesToRadians(-30.0), 1e-12);
  EXPECT_NEAR(m[0].jointSpeedRadPerS, base::degreesToRadians(9.0), 1e-12);
  EXPECT_TRUE(m[1].frame_T_tcp.translation().isApprox(Eigen::Vector3d(300, 10, 200), 1e-12));
  // R = Rz(30) Ry(20) Rx(10).
  EXPECT_LT(Eigen::Quaterniond(m[1].frame_T_tcp.linear())
                .angularDistance(Eigen::Quaterniond(.9515485, .0381346, .1893079, .2392983)),
            1e-6);
  EXPECT_TRUE(m[2].frame_T_tcp.translation().isApprox(Eigen::Vector3d(100, 10, 5), 1e-9));
  EXPECT_DOUBLE_EQ(m[2].speedMmPerS, 20.0);
  // The next motion speeds up while this one slows down: v^2 / (2 a) before the corner.
  EXPECT_DOUBLE_EQ(m[2].blendMm, 0.4);
  EXPECT_EQ(m[3].blendMm, 0.0);
  EXPECT_NEAR(program.flange_T_tcp.translation().z(), 120.0, 1e-12);
}

TEST(SpelplusReader, takesNamesPointsAndFunctions) {
  const std::string main =
      "' by hand\r\nReal fast, height\r\nFunction main\r\n  Integer i\r\n  motor on\r\n"
      "  Power High ' at once\r\n  Weight 2, 100\r\n  Speed 20; Accel 30, 30\r\n  fast = 2 * 15\r\n"
      "  height = 5\r\n  SpeedS fast\r\n  AccelS 200, 100\r\n  Off 1; AIO_Out 1, 5\r\n"
      "  P1 = XY(300, 0, 100, 90, 0, 180) /R\r\n  Go P1\r\n  Move P1 -Z(height) +X(10)\r\n"
      "  On 1\r\n  Print \"layer; 1\"\r\n  Call layer\r\n  layer\r\n  Off 1; AIO_Out 1, "
      "0\r\nFend\r\n";
  const std::string layer = "Function layer()\r\n  CP On\r\n  Move P1 :Z(95) /1\r\n  CP Off\r\n"
                            "  Move XY(300,20,95,90,0,180)\r\nFend\r\n";
  const auto unknown = readFiles({{"main.prg", main}, {"layer.prg", layer}});
  expectDefect(unknown, 3, "only the controller knows"); // Local 1 is not in the text
  const std::string known =
      layer.substr(0, layer.find(" /1")) + layer.substr(layer.find(" /1") + 3);
  const auto program = readFiles({{"main.prg", main}, {"layer.prg", known}});
  expectSound(program);
  ASSERT_EQ(program.motions.size(), 6u);
  const auto& m = program.motions;
  EXPECT_TRUE(m[1].frame_T_tcp.translation().isApprox(Eigen::Vector3d(310, 0, 95), 1e-12));
  EXPECT_DOUBLE_EQ(m[1].speedMmPerS, 30.0);
  EXPECT_DOUBLE_EQ(m[1].accelerationMmPerS2, 100.0);
  EXPECT_DOUBLE_EQ(m[2].blendMm, 4.5);
  EXPECT_EQ(m[2].file, 1u);
  EXPECT_DOUBLE_EQ(m[2].flowMm3PerS, 20.0);
  EXPECT_EQ(filesOfSpelplus(main), std::vector<std::string>{"layer.prg"});
}

TEST(SpelplusReader, namesStatementsThatItCannotRead) {
  const std::string move = "Go XY(300,0,100,0,0,180)\n";
  const struct {
    const char* line;
    const char* part;
  } cases[] = {{"Jump XY(0,0,0,0)\n", "not known"},
               {"Arc P1, P2\n", "not known"},
               {"TMove XY(1,0,0,0)\n", "not known"},
               {"Move P7\n", "not understood"},
               {"Move XY(1,2,3)\n", "not understood"},
               {"Move XY(400000,0,0,0,0,0)\n", "not understood"},
               {"Move XY(301,0,100,0,0,180) Till Sw(1) = On\n", "till"},
               {"Move XY(301,0,100,0,0,180) CP ! D50; On 1 !\n", "not understood"},
               {"Move AglToPls(0,0,0,0,0,0)\n", "posture"},
               {"Move XY(300,0,100,20,0,180)\n", "ROT"},
               {"Move XY(301,0,100,0,0,180) ROT\n", "speedr"},
               {"SpeedR 10\nMove XY(301,0,100,0,0,180) ROT\n", "does not turn"},
               {"Go XY(301,0,100,0,0,180) CP\n", "Go CP"},
               {"Move XY(301,0,100,0,0,180) ECP\n", "not both"},
               {"Tool 3\n", "only the controller knows"},
               {"Power Low\nMove XY(301,0,100,0,0,180)\n", "Power High"},
               {"AIO_Out 1, 11\n", "10 V"},
               {"On 1, 0.5\n", "persistent"},
               {"Call other\n", "is missing"},
               {"part\n", "calls itself"},
               {"x = 5\n", "not known"},
               {"If Sw(1) = On Then\n", "not known"},
               {"Do While True\n", "not known"},
               {"SpeedS 0\n", "invalid speed"}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    const std::string two = c.line;
    const bool second = std::count(two.begin(), two.end(), '\n') == 2;
    expectDefect(read(move + two + "Move XY(305,0,100,0,0,180)\n"), second ? 10 : 9, c.part);
  }
  EXPECT_FALSE(readFiles({{"a.prg", "Function a\n"}}).complete);
}

using Spelplus = test::Programs;

TEST_F(Spelplus, aFixedNozzleIsAnExternalControlPoint) {
  appendRandom(4, 60);
  const plan::Program program = writeProgram("spel", input());
  const std::string& text = program.files[0].text;
  EXPECT_NE(text.find("  TLSet 1, XY(0,0,100,0,0,0)\r\n  Tool 1\r\n  ECPSet 1, "
                      "XY(-800,-250,0,0,0,180)\r\n  ECP 1\r\n  AutoLJM On\r\n"),
            std::string::npos)
      << text.substr(0, 2000);
  // Slow until the operator has confirmed and the arm is at its start.
  const std::size_t low = text.find("Power Low"), asked = text.find("Pause"),
                    first = text.find("  Go "), high = text.find("Power High");
  EXPECT_TRUE(low < asked && asked < first && first < high && high != std::string::npos);
  EXPECT_LT(high, text.find("  Move "));
  const plan::ReadProgram back = readProgram("spel", program.files, process::Tooling(process_));
  expectSound(back);
  ASSERT_TRUE(back.base_T_nozzle && back.base_T_nozzle->isApprox(cell_->base_T_fixed(), 1e-6));
  EXPECT_EQ(back.motions[5].target, plan::TargetKind::WorkPose);
}

TEST_F(Spelplus, longProgramsAreCalledFileByFile) {
  appendRandom(9, 1000);
  ProgramInput cut = input();
  cut.options.motionsPerFile = 100;
  const plan::Program program = writeProgram("spel", cut);
  ASSERT_GT(program.files.size(), 8u);
  const plan::ReadProgram back = readProgram("spel", program.files, process::Tooling(process_));
  expectSound(back);
  ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
  EXPECT_EQ(filesOfSpelplus(program.files[0].text).size(), program.files.size() - 1);
}

// Corners are rounded by no more than the other dialects round them.
TEST_F(Spelplus, cornersStayWithinTheirBlends) {
  appendRandom(6, 2000);
  const plan::ReadProgram ours =
      readProgram("spel", writeProgram("spel", input()).files, process::Tooling(process_));
  const plan::ReadProgram krl =
      readProgram("krl", writeProgram("krl", input()).files, process::Tooling(process_));
  ASSERT_EQ(ours.motions.size(), krl.motions.size());
  std::size_t rounded = 0;
  for (std::size_t i = 1; i < ours.motions.size(); ++i) {
    rounded += ours.motions[i].blendMm > 0.0;
    // KRL's are rounded down to a step of a fifth.
    EXPECT_LE(ours.motions[i].blendMm, 1.26 * krl.motions[i].blendMm + 1e-9) << i;
  }
  EXPECT_GT(rounded, 1500u);
}

TEST(SpelplusWords, areTheLanguagesOwn) {
  for (const char* word : {"move", "Go", "FEND", "SpeedS"})
    EXPECT_TRUE(isSpelplusWord(word)) << word;
  EXPECT_FALSE(isSpelplusWord("print_part"));
}

} // namespace
} // namespace voluta::program
