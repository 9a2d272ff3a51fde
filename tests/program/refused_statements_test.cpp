// Words that the user's own statements must not have, per language.
#include "program/dialect.h"
#include "program/own_lines.h"
#include "program/refused_statements.h"

#include <gtest/gtest.h>
#include <string_view>
#include <vector>

namespace voluta::program {
namespace {

struct Row {
  std::string_view dialect;
  std::vector<std::string_view> refused, allowed;
};
const Row kRows[] = {
    {"urscript",
     {"movel(p[0,0,0,0,0,0])", "set_tcp(p[0,0,0.1,0,0,0])", "x = 1; servoj([0,0,0,0,0,0])", "halt",
      "set_standard_analog_out(0,0.5)", "while True:", "set_payload(1.0)", "popup(\"Wait\")"},
     {"set_tool_voltage(24)", "own_call(1)", "textmsg(\"movel(a)\")", "sleep(1) # movel(b)",
      "removel(1)"}},
    {"gcode-extended",
     {"G1 X10",       "g01x10",   "X10 Y5",      "M104 S0",
      "M109S200",     "M140 S60", "G92 E0",      "G28",
      "T1",           "M221 S50", "M42 P3 S255", "M30",
      "N10 G4 P1 G1", "G91",      "M82",         "SET_PIN PIN=a VALUE=1",
      "M0",           "M98 P100", "E-5",         "M600"},
     {"M150 R255 B0", "G4 P500", "M117 G1 is next", "M300 S440 P200", "own_call(1)", "M118 T1 done",
      "M150 R1 ; G1 X10"}},
    {"rapid",
     {"MoveL p1,v10,z0,t;", "SetDO doA,1;", "GOTO here;", "Stop;", "PDispSet p;", "%\"MoveL\"%;",
      "TriggIO a,1;", "VelSet 50,100;"},
     {"TPWrite \"MoveL\";", "own_call 1;", "WaitTime 1; ! MoveL", "ClkStart c;"}},
    {"krl",
     {"LIN P1", "$TOOL=TOOL_DATA[2]", "$BASE.X=10", "$VEL.CP=0.1", "$OUT[3]=TRUE", "HALT", "GOTO A",
      "PULSE($OUT[1],TRUE,1)", "$ANOUT[1]=0.5", "ptp home"},
     {"own_call(1)", "MsgNotify(\"LIN\")", "WAIT SEC 1", "$FLAG[1]=TRUE ; LIN"}},
    {"spel",
     {"Go P1", "Tool 2", "On 12", "Pause", "GoTo here", "Power High", "AIO_Out 1, 5", "Motor Off"},
     {"Call own", "Print \"Go\"", "MemOn 1", "Wait 1 ' Go P1"}},
    {"melfa",
     {"Mvs P1", "Tool PT", "M_Out(10)=1", "Hlt", "GoTo *A", "Spd 10", "Servo Off", "M_Outw(16)=3"},
     {"own_call(1)", "Dly 1", "M_00=1", "Dly 1 ' Mvs P1"}},
    {"tmscript",
     {"Line(\"CPP\",0,0,0,0,0,0,100,200,0,false)", "ChangeTCP(\"T1\")",
      "IO[\"ControlBox\"].DO[3]=1", "Pause()", "if(a==1)", "PVTEnter(1)", "ScriptExit()"},
     {"own_call(1)", "var_a = 1", "socket_send(\"Line\")", "own(1) // Line()"}}};

TEST(RefusedStatements, AreFoundInEveryLanguage) {
  for (const Row& row : kRows) {
    for (const std::string_view statement : row.refused)
      EXPECT_TRUE(refusedWord(row.dialect, statement)) << row.dialect << ": " << statement;
    for (const std::string_view statement : row.allowed) {
      const auto refused = refusedWord(row.dialect, statement);
      EXPECT_FALSE(refused) << row.dialect << ": " << statement << ": " << refused->word;
    }
  }
}

// A new dialect with statements needs rows of its words.
TEST(RefusedStatements, NoStatementSetsAnOutput) {
  for (const Dialect& dialect : dialects())
    if (hasWordFor(dialect, plan::EventKind::Statement)) {
      const plan::TrajectoryEvent output{
          .kind = plan::EventKind::Output, .tool = outputWords(dialect.id).first, .on = true};
      EXPECT_TRUE(refusedWord(dialect.id, ownLine(dialect.id, output))) << dialect.id;
    }
}

// Firmwares have more codes than any list of dangerous ones.
TEST(RefusedStatements, CodesThatNobodyKnowsAreRefused) {
  for (const char* line :
       {"G26", "M48", "M568 P0 S200", "G41", "M28 a.g", "M7", "M280 P0 S90", "G[0+1] X10",
        "G+1 X10", "G#1 X10", "M118 S\"a\" G1 X9", "M9999", "g999"})
    EXPECT_TRUE(refusedWord("gcode", line)) << line;
  for (const char* line : {"M117 G1 X10", "M118 S\"G1 X10\"", "M300 S440 P200", "MY_MACRO P=1",
                           "M73 P50", "G4 P100 ; G1", "M400"})
    EXPECT_FALSE(refusedWord("gcode", line)) << line;
}

TEST(RefusedStatements, TheVariableThatIsSetIsNamed) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(assignedNames("global V_a = 3"), Names{"v_a"});
  EXPECT_EQ(assignedNames("tNozzle.tframe.trans.z:=0;"), Names{"tnozzle"});
  EXPECT_EQ(assignedNames("a:=1; tNozzle.tframe.trans.z:=0;"), (Names{"a", "tnozzle"}));
  EXPECT_EQ(assignedNames("x=1; V_a=3"), (Names{"x", "v_a"}));
  EXPECT_EQ(assignedNames("textmsg(\"b;c=1\")"), Names{});
  EXPECT_EQ(assignedNames("own(a=1)"), Names{});
  EXPECT_EQ(assignedNames("if a == 1:"), Names{});
  EXPECT_TRUE(hasName("  MoveL p1,v10,z0,tNozzle;", "tnozzle"));
  EXPECT_FALSE(hasName("  MoveL p1,v10,z0,tNozzle2;", "tnozzle"));
}

} // namespace
} // namespace voluta::program
