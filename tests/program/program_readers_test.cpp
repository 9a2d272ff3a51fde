// Programs as people write them, and statements that readers must not ignore.
#include "base/units.h"
#include "process/process.h"
#include "program/dialect.h"
#include "program/filament.h"
#include "program_defects.h"

#include <cmath>
#include <gtest/gtest.h>

namespace voluta::program {
namespace {

using test::expectDefect;

plan::ReadProgram read(std::string_view format, std::string text) {
  process::Process process;
  process.maxFlowMm3PerS = 40.0;
  return readProgram(format, {{"file", std::move(text)}}, process::Tooling(process));
}

// A whole program around the given body.
std::string script(const std::string& body) {
  return "def f():\n set_tcp(p[0,0,0.1,0,0,0])\n set_standard_digital_out(0,False)\n"
         " set_standard_analog_out(0,0)\n" +
         body + "set_standard_digital_out(0,False)\nset_standard_analog_out(0,0)\nend\nf()\n";
}

TEST(UrscriptReader, takesHandWrittenVariations) {
  const auto program =
      read("urscript", "# my program\r\n\r\ndef  kitten( ) :  # start\r\n"
                       "\ttextmsg(\"hello # not a comment\")\r\n"
                       "  set_tcp( p[ 0.0, 0, 1e-1, 0,0, +1.5 ] )\r\n"
                       "  set_payload(1.2, [0, 0, 0.05])\r\n"
                       "  set_digital_out(0, false)\r\n"
                       "  set_analog_out(0, 0.0)\r\n"
                       "  movej([0,-1.5,1.5,-1.5,-1.5,0])\r\n"
                       "  movel(p[-.4, 0.1, 0.3, 0, 3.14, 0], 0.5, 0.1, 0, 0.002)\r\n"
                       "  set_digital_out( 0 , true ) # on\r\n"
                       "  set_analog_out(0, 0.25)\r\n"
                       "  movel( p[-.4,0.1,0.31,0,3.14,0] , r = 0.001, v=.02 , a=1 )\r\n"
                       "  movel(p[-.4,0.1,0.32,0,3.14,0], v=0.02, t=0.5)\r\n"
                       "  movep(p[-.4,0.1,0.33,0,3.14,0], 1.2, 0.03, 0.004)\r\n"
                       "  set_digital_out(0, false)\r\n"
                       "  set_analog_out(0, 0)\r\n"
                       "  set_digital_out(3, True)\r\n"
                       "end\r\nkitten()\r\n");
  EXPECT_TRUE(program.complete);
  for (const auto& d : program.defects)
    ADD_FAILURE() << d.line << ": " << voluta::base::english(d.reason);
  ASSERT_EQ(program.motions.size(), 5u);
  EXPECT_NEAR(program.flange_T_tcp.translation().z(), 100.0, 1e-12);
  EXPECT_NEAR(Eigen::AngleAxisd(program.flange_T_tcp.linear()).angle(), 1.5, 1e-12);
  const auto& m = program.motions;
  EXPECT_EQ(m[0].line, 9u);
  EXPECT_EQ(m[0].target, plan::TargetKind::Joints);
  EXPECT_TRUE(m[0].jointInterpolated);
  EXPECT_DOUBLE_EQ(m[0].jointSpeedRadPerS, 1.05); // the controller's default
  EXPECT_EQ(m[1].target, plan::TargetKind::FlangePose);
  EXPECT_FALSE(m[1].jointInterpolated || m[1].extruding);
  EXPECT_DOUBLE_EQ(m[1].speedMmPerS, 100.0);
  EXPECT_DOUBLE_EQ(m[1].blendMm, 2.0);
  EXPECT_TRUE(m[1].frame_T_tcp.translation().isApprox(Eigen::Vector3d(-400, 100, 300)));
  EXPECT_DOUBLE_EQ(m[2].speedMmPerS, 20.0);
  EXPECT_DOUBLE_EQ(m[2].blendMm, 1.0);
  EXPECT_TRUE(m[2].extruding);
  EXPECT_DOUBLE_EQ(m[2].flowMm3PerS, 10.0);
  EXPECT_DOUBLE_EQ(m[3].durationS, 0.5);
  EXPECT_DOUBLE_EQ(m[4].speedMmPerS, 30.0);
  EXPECT_DOUBLE_EQ(m[4].blendMm, 4.0);
}

TEST(UrscriptReader, namesStatementsThatItCannotRead) {
  const char* move = "movel(p[-0.4,0,0.3,0,3,0],a=1,v=0.1)\n";
  const struct {
    const char* line;
    const char* part;
  } cases[] = {
      {"movel(p[-0.4,0,0.3,0,3],a=1,v=0.1)\n", "pose"},
      {"movel(p[-0.4,0,0.3,0,3,zero],a=1,v=0.1)\n", "not understood"},
      {"movel(p[-0.4,0,0.3,0,3,0],a=1,v=-0.1)\n", "argument v"},
      {"movel(p[-0.4,0,0.3,0,3,0],a=1,v=0)\n", "never arrives"},
      {"movel(p[-0.4,0,0.3,0,3,0],a=1,w=0.1)\n", "unknown"},
      {"movel(p[-0.4,0,0.3,0,3,0],v=1,v=0.1)\n", "twice"},
      {"movel(p[-0.4,0,400,0,3,0],a=1,v=0.1)\n", "reach"},
      {"movel(p[-0.4,0,nan,0,3,0],a=1,v=0.1)\n", "not understood"},
      {"movel(p[-0.4,0,0.3,0,3,0],a=1,v=0.1\n", "not understood"},
      {"movel()\n", "without a target"},
      {"movej([0,0,0],a=1,v=1)\n", "joints"},
      {"movec(p[0,0,0,0,0,0],p[0,0,0,0,0,0])\n", "on a line"},
      {"servoj([0,0,0,0,0,0])\n", "not known"},
      {"while True:\n", "not understood"},
      {"x = y\n", "not understood"},
      {"set_standard_analog_out(0,1.5)\n", "0..1"},
      {"set_standard_digital_out(0,0.5)\n", "output"},
      {"set_tcp(p[0,0,0.2,0,0,0])\n", "different TCP"},
      {"sleep()\n", "seconds"},
      {"f()\n", "calls itself"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    const auto program = read("urscript", script(std::string(move) + c.line + move));
    expectDefect(program, 6, c.part);
    EXPECT_EQ(program.motions.size(), 2u);
  }
}

TEST(UrscriptReader, missesEndCallAndTcp) {
  const std::string whole = script("movel(p[-0.4,0,0.3,0,3,0],a=1,v=0.1)\n");
  EXPECT_TRUE(read("urscript", whole).complete);
  // Sent to a port it runs by itself; the call is missed where the text states that there is one.
  const std::string uncalled = whole.substr(0, whole.find("f()\n", 10));
  EXPECT_TRUE(read("urscript", uncalled).complete);
  expectDefect(read("urscript", "# called in the last line\n" + uncalled), 9, "never called");
  EXPECT_FALSE(read("urscript", whole.substr(0, whole.rfind("end"))).complete);
  EXPECT_FALSE(read("urscript", "").complete);
  expectDefect(read("urscript", "def f():\nset_standard_digital_out(0,False)\n"
                                "set_standard_analog_out(0,0)\n"
                                "movel(p[-0.4,0,0.3,0,3,0])\nend\nf()\n"),
               4, "set_tcp");
}

// As RoboDK's post writes it: variables, a reference frame, procedures in and before the program.
TEST(UrscriptReader, takesVariablesAndProcedures) {
  const auto program =
      read("urscript",
           "def Prog1():\n  # Global parameters:\n  global speed_ms    = 0.250\n"
           "  global accel_mss   = 1.200\n  global blend_radius_m = 0.001\n"
           "  global ref_frame = p[0,0,0,0,0,0]\n"
           "  def Extruder_On():\n    set_digital_out(0, True)\n  end\n"
           "  def Extruder_Off():\n    set_digital_out(0, False)\n    set_analog_out(0, 0)\n  end\n"
           "  ref_frame = p[0.1,0.2,0.3,0,0,1.5707963267948966]\n"
           "  set_tcp(p[0,0,0.1,0,0,0])\n  Extruder_Off()\n"
           "  movej([0,d2r(-90),1.5,-1.5,-1.5,0],1.4,0.75,0,0)\n"
           "  set_analog_out(0, (0.1 + 0.3) / 2)\n  Extruder_On()\n  speed_ms = 2*0.01\n"
           "  movel(pose_trans(ref_frame,p[0.01,0,0,0,0,0]),accel_mss,speed_ms,0,blend_radius_m)\n"
           "  local target = p[0.1,-0.1,0.2,0,3.14,0]\n  movel(target, t=-(-0.5))\n"
           "  Extruder_Off()\nend\nProg1()\n");
  for (const auto& d : program.defects)
    ADD_FAILURE() << d.line << ": " << voluta::base::english(d.reason);
  EXPECT_TRUE(program.complete);
  ASSERT_EQ(program.motions.size(), 3u);
  EXPECT_NEAR(program.motions[0].joints[1], -base::kPi / 2, 1e-12);
  EXPECT_TRUE(
      program.motions[1].frame_T_tcp.translation().isApprox(Eigen::Vector3d(100, 210, 300), 1e-9));
  EXPECT_DOUBLE_EQ(program.motions[1].speedMmPerS, 20.0);
  EXPECT_DOUBLE_EQ(program.motions[1].accelerationMmPerS2, 1200.0);
  EXPECT_DOUBLE_EQ(program.motions[1].flowMm3PerS, 8.0);
  EXPECT_DOUBLE_EQ(program.motions[2].durationS, 0.5);
  EXPECT_EQ(program.motions[2].line, 23u);
}

TEST(UrscriptReader, namesWhereItsUnderstandingEnds) {
  const struct {
    const char* line;
    const char* part;
  } cases[] = {{"movel(pose_add(p[0,0,0,0,0,0],p[0,0,0,0,0,0]))\n", "not understood"},
               {"movel(get_actual_tcp_pose())\n", "not understood"},
               {"x = 1/0\n", "not understood"},
               {"if x == 1:\n", "not understood"},
               {"movel(unknown)\n", "not understood"},
               {"x = ((((((((((((((((((((((((1))))))))))))))))))))))))\n", "not understood"}};
  const char* move = "movel(p[-0.4,0,0.3,0,3,0],a=1,v=0.1)\n";
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    const bool block = std::string(c.line).starts_with("if");
    expectDefect(
        read("urscript", script(std::string(move) + c.line + move + (block ? "end\n" : ""))), 6,
        c.part);
  }
  expectDefect(read("urscript", "def f():\nmovel(p[0,0,0,0,0,0])\n"), 2, "no end");
  expectDefect(read("urscript", "def f():\nend\ndef g():\nend\n"), 4, "never called");
}

std::string withCrLf(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return out;
}

// As RoboDK's post writes it: a header, data that is assigned, parts by name, a comma before
// \\WObj.
TEST(RapidReader, takesProceduresAndDataAsOthersWriteThem) {
  const auto program = read(
      "rapid",
      withCrLf(
          "%%%\n  VERSION:1\n  LANGUAGE:ENGLISH\n%%%\n\nMODULE MOD_Prog1\n"
          "  PERS wobjdata rdkWObj := [FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n"
          "  PERS tooldata rdkTool := "
          "[TRUE,[[0,0,0],[1,0,0,0]],[2,[0,0,20],[1,0,0,0],0,0,0.005]];\n"
          "  VAR speeddata rdkSpeed := [500,500,500,500];\n"
          "  VAR extjoint rdkExtax := [9E9,9E9,9E9,9E9,9E9,9E9];\n"
          "  PROC Main()\n    ConfJ \\Off;\n    ConfL \\Off;\n"
          "    rdkTool := [TRUE,[[0,0,100],[1,0,0,0]],[2,[0,0,20],[1,0,0,0],0,0,0.005]];\n"
          "    Off;\n"
          "    MoveAbsJ [[0,10,20,30,40,50],rdkExtax],rdkSpeed,z1,rdkTool,\\WObj:=rdkWObj;\n"
          "    Layer;\n    Layer;\n  ENDPROC\n"
          "  LOCAL PROC Off()\n    SetDO doExtruder,0;\n    SetAO aoFlow,0;\n  ENDPROC\n"
          "  PROC Layer()\n    CONST robtarget p1 := [[400,0,300],[0,0,1,0],[0,0,0,0],rdkExtax];\n"
          "    rdkSpeed := v20;\n    SetDO doExtruder,1; SetAO aoFlow,0.5;\n"
          "    MoveL Offs(p1,0,10,-5),rdkSpeed,fine,rdkTool\\WObj:=rdkWObj;\n    Off;\n  ENDPROC\n"
          "ENDMODULE\n"));
  for (const auto& d : program.defects)
    ADD_FAILURE() << d.line << ": " << voluta::base::english(d.reason);
  EXPECT_TRUE(program.complete);
  ASSERT_EQ(program.motions.size(), 3u);
  EXPECT_EQ(program.motions[0].line, 16u);
  EXPECT_EQ(program.flange_T_tcp.translation(), Eigen::Vector3d(0, 0, 100));
  EXPECT_EQ(program.motions[1].frame_T_tcp.translation(), Eigen::Vector3d(400, 10, 295));
  EXPECT_EQ(program.motions[1].line, 28u);
  EXPECT_EQ(program.motions[2].line, 28u);
  EXPECT_TRUE(program.motions[1].extruding);
  EXPECT_EQ(program.motions[1].speedMmPerS, 20.0);
  EXPECT_EQ(program.load->kg, 2.0);
}

TEST(GcodeReader, takesTheAppendixAndReprap) {
  const auto program =
      read("gcode-extended", "G92 E0\nG28\nG0 F600 X4.391 Y-8.398 Z1.500\n"
                             "G1 X3.650 Y-9.611 Z1.500 E1.026\n"
                             "N7 G1 X6.338 Y8.390 Z46.300 nX-0.094 nY0.127 nZ0.987 E4.324 *55\n"
                             "g1 x7 (half) y8\nM83\nG1 X8 E0.5\nG1 E-2 F1800\nG1 E2\nG1 X9 E.25\n"
                             "M104 S0\nM84\n; end\n");
  EXPECT_TRUE(program.complete);
  for (const auto& d : program.defects)
    ADD_FAILURE() << d.line << ": " << voluta::base::english(d.reason);
  const auto& m = program.motions;
  ASSERT_EQ(m.size(), 6u);
  const double area = base::kPi / 4 * 1.75 * 1.75;
  EXPECT_FALSE(m[0].extruding);
  EXPECT_DOUBLE_EQ(m[0].speedMmPerS, 10.0);
  EXPECT_TRUE(m[0].position.isApprox(Eigen::Vector3d(4.391, -8.398, 1.5)));
  EXPECT_EQ(m[0].direction, Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(m[1].volumeMm3, 1.026 * area, 1e-12);
  EXPECT_TRUE(m[1].extruding);
  EXPECT_NEAR(m[2].volumeMm3, (4.324 - 1.026) * area, 1e-12);
  EXPECT_NEAR(m[2].direction.norm(), 1.0, 1e-15);
  EXPECT_LT((m[2].direction - Eigen::Vector3d(-0.094, 0.127, 0.987)).norm(), 2e-3);
  EXPECT_EQ(m[2].line, 5u);
  EXPECT_EQ(m[3].position, Eigen::Vector3d(7, 8, 46.3));
  EXPECT_EQ(m[3].volumeMm3, 0.0);
  EXPECT_NEAR(m[4].volumeMm3, 0.5 * area, 1e-12);
  EXPECT_NEAR(m[5].volumeMm3, 0.25 * area, 1e-12); // drawn back and pushed forward: not twice
}

TEST(GcodeReader, usesTheStatedFilament) {
  const auto program = read("gcode-extended", "; filament diameter 2.85 mm\nG0 X0 Y0 Z0 F600\n"
                                              "G1 X1 E1\nM104 S0\nM84\n; end\n");
  ASSERT_EQ(program.motions.size(), 2u);
  EXPECT_NEAR(program.motions[1].volumeMm3, base::kPi / 4 * 2.85 * 2.85, 1e-12);
}

TEST(GcodeReader, countsABlobAsAPauseWithMaterial) {
  const auto program = read("gcode-extended", "G1 E5 F300\nG92 E0\nG0 X0 Y0 Z0 F600\nG1 E3\n"
                                              "M104 S0\nM84\n; end\n");
  EXPECT_EQ(program.motions.size(), 1u);
  ASSERT_EQ(program.pauses.size(), 2u); // the first one is the prime
  EXPECT_EQ(program.pauses[1].before, 1u);
  EXPECT_NEAR(program.pauses[1].volumeMm3, 3.0 * program::filamentArea(), 1e-9);
}

// The first of two tools moves to the change, at most.
TEST(GcodeReader, endsWhenTheToolsThatExtrudedAreCold) {
  process::Process process;
  const process::Tooling two({{process}, {process}});
  const auto isComplete = [&](const std::string& end) {
    return readProgram("gcode",
                       {{"file", "G21\nG90\nM82\nM109 T1 S210\nG92 E0\nG0 X0 Y0 Z1 F600\nT1\n"
                                 "G1 X1 E0.1\n" +
                                     end + "M84\n; end\n"}},
                       two)
        .complete;
  };
  EXPECT_TRUE(isComplete("M104 T1 S0\n"));
  EXPECT_FALSE(isComplete("M104 T0 S0\n"));
  EXPECT_FALSE(isComplete(""));
}

TEST(GcodeReader, namesWordsThatItCannotRead) {
  const struct {
    const char* line;
    const char* part;
  } cases[] = {
      {"G1 X1 nX0.1 nY0 nZ0.9\n", "unit vector"},
      {"G1 X1 nX0 nZ1\n", "nX, nY and nZ"},
      {"G1 X1 F0\n", "speed"},
      {"G1 X10 YF1200\n", "letter Y"},
      {"G1 X10 Y F1200\n", "letter Y"},
      {"G0 X10 Y\n", "letter Y"},
      {"G X10 Y2\n", "letter G"},
      {"G1 X1 nX nY0 nZ1\n", "letter nX"},
      {"G92 E\n", "letter E"},
      {"G4 S\n", "letter S"},
      {"M104 S\n", "letter S"},
      {"G1 X1..2\n", "not understood"},
      {"G1 X1 X2\n", "not understood"},
      {"G2 X1 I3\n", "unknown G command"},
      {"G20\n", "inches"},
      {"G91\n", "relative"},
      {"G92 X0\n", "origin"},
      {"X1 Y2\n", "without a command"},
      {"M999\n", "unknown M command"},
      {"G1 X1 M3\n", "two commands"},
      {"G1 Xnan\n", "not understood"},
      {"G1 X1 I2\n", "word I"},
      {"$%&\n", "not understood"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    expectDefect(read("gcode-extended",
                      std::string("G0 X0 Y0 Z0 F600\n") + c.line + "M104 S0\nM84\n; end\n"),
                 2, c.part);
  }
  for (const std::string home : {"G28 X Y", "G28XYZ", "g28 w"})
    for (const std::string off : {"M84", "M84 X Y", "M18E"})
      EXPECT_TRUE(read("gcode-extended", home + "\nG0 X0 Y0 Z0 F600\nM104 S0\n" + off + "\n; end\n")
                      .defects.empty())
          << home << " " << off;
  expectDefect(read("gcode-extended", "G1 X1 Y2 F600\nM104 S0\nM84\n; end\n"), 1, "X, Y and Z");
  expectDefect(read("gcode-extended", "G0 X1 Y2 Z3\nM104 S0\nM84\n; end\n"), 1, "before any speed");
}

TEST(JointTableReader, namesRowsThatItCannotRead) {
  const std::string head = "time_s,j1_deg,j2_deg,extruded_mm3,waypoint,move\n";
  const auto good = read("csv", head + "0,0,90,0,-1,joint\n1, 1 ,91,0.5,0,print\n# end\n");
  EXPECT_TRUE(good.complete && good.defects.empty());
  ASSERT_EQ(good.motions.size(), 2u);
  EXPECT_DOUBLE_EQ(good.motions[0].joints[1], base::kPi / 2);
  EXPECT_DOUBLE_EQ(good.motions[1].volumeMm3, 0.5);
  EXPECT_DOUBLE_EQ(good.motions[1].durationS, 1.0);
  EXPECT_TRUE(good.motions[0].jointInterpolated && !good.motions[1].jointInterpolated);
  EXPECT_TRUE(good.motions[1].extruding);
  const struct {
    const char* line;
    const char* part;
  } cases[] = {{"2,0,0,1,-1,fly\n", "not a row"},         {"2,0,0,1,print\n", "not a row"},
               {"2,0,0,0,1,-1,print\n", "not a row"},     {"2,x,0,1,-1,print\n", "not a row"},
               {"0.5,0,0,1,1,print\n", "time decreases"}, {"2,0,0,0.1,1,print\n", "decreases"},
               {"2,0,0,1,1.5,print\n", "integer"},        {"", "truncated"}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    const bool cut = !*c.line;
    expectDefect(read("csv", head + "0,0,90,0,-1,joint\n1,1,91,0.5,0,print\n" + c.line +
                                 (cut ? "" : "# end\n")),
                 cut ? 3 : 4, c.part);
  }
  EXPECT_FALSE(read("csv", "0,0,90,0,-1,joint\n# end\n").complete);
}

} // namespace
} // namespace voluta::program
