// Programs in the form of makers' texts, checked by grammars that are independent of our readers.
#include "program_fixture.h"

#include "program/dialect.h"
#include "program/extruder.h"
#include "program/gcode/extruder_axis.h"
#include "program/makers_grammars.h"

#include <algorithm>
#include <functional>
#include <tuple>

namespace voluta::program {
namespace {

std::string withCrLf(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return out;
}

// Line i (1-based) with `from` replaced.
std::string changed(const std::string& text, const std::string& from, const std::string& to,
                    std::size_t& line) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) {
    ADD_FAILURE() << "not there: " << from;
    return text;
  }
  line = 1 + static_cast<std::size_t>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  return text.substr(0, at) + to + text.substr(at + from.size());
}

struct Damage {
  const char *from, *to;
};
using Grammar = std::function<std::size_t(const std::string&)>;

void expectFound(const Grammar& wrongLine, const std::string& text,
                 std::initializer_list<Damage> all) {
  EXPECT_EQ(wrongLine(text), 0u) << text.substr(0, 3000);
  for (const Damage& d : all) {
    std::size_t line = 0;
    const std::string bad = changed(text, d.from, d.to, line);
    const std::size_t found = wrongLine(bad);
    EXPECT_TRUE(found == line || found == line + 1)
        << "'" << d.from << "' as '" << d.to << "': line " << line << ", found " << found;
  }
}

class MakersGrammars : public test::Programs {
protected:
  std::vector<std::string> written(const char* format) {
    randomFor(findDialect(format), 3, 400);
    std::vector<std::string> texts;
    for (const plan::ProgramFile& file : writeProgram(format, input()).files)
      if (file.name.ends_with(findDialect(format).extension))
        texts.push_back(file.text);
    EXPECT_FALSE(texts.empty());
    return texts;
  }
};

TEST_F(MakersGrammars, rapid) {
  for (const std::string& module : written("rapid"))
    expectFound(test::wrongRapidLine, module,
                {{":=[TRUE", "=[TRUE"},
                 {",fine,", ",fine "},
                 {",9E9,9E9,9E9]]", ",9E9,9E9]]"},
                 {"SetDO doExtruder,0;", "SetDO doExtruder,0"},
                 {"SetAO aoFlow,0;", "SetAO aoFlow;"},
                 {"ConfL\\Off", "ConfL Off"},
                 {"PROC main()", "PROC main"},
                 {"    MoveL [", "    MoveM ["},
                 {"[FALSE,0", "[FALSE,0,0"},
                 {"UIMsgBox \"", "UIMsgBox "},
                 {"PERS tooldata tNozzle", "PERS tooldata tNozzleWithANameLongerThanThirtyTwo"},
                 {"ENDPROC", "ENDPRC"}});
  useRod();
  trajectory_ = {};
  plan_ = {};
  appendRandomOnRod(3, 200);
  EXPECT_EQ(test::wrongRapidLine(writeProgram("rapid", input()).files[0].text), 0u);
}

TEST_F(MakersGrammars, gcode) {
  expectFound(
      [](const std::string& t) { return test::wrongGcodeLine(t, true); },
      written("gcode-extended").at(0),
      {{"\nG1 X", "\nG1 X1e1"}, {"G0 X", "G0 G1 X"}, {"nY0", "nX0"}, {"G90\n", "G90 G91\n"}});
  EXPECT_NE(test::wrongGcodeLine(written("gcode-extended").at(0), false), 0u);
  expectFound([](const std::string& t) { return test::wrongGcodeLine(t, false); },
              written("gcode").at(0),
              {{"G0 X", "X"}, {"F6000", "X6000"}, {"M104 S", "M104 Sx"}, {"G21\n", "G21 G20\n"}});
  const std::string table = written("gcode-bc").at(0);
  expectFound([](const std::string& t) { return test::wrongGcodeLine(t, false); }, table,
              {{" C-", " B-"}, {" C-", " C1.2.3-"}, {"G93\n", "G93 G94\n"}});
  // Every motion has its time of its own.
  std::size_t line = 0;
  std::string bare = changed(table, "G93\nG1 X", "G93\nG1 Q", line);
  bare = table;
  const std::size_t first = bare.find("G1 X", bare.find("G93\n")), f = bare.find(" F", first);
  bare.erase(f, bare.find('\n', f) - f);
  EXPECT_NE(test::wrongGcodeLine(bare, false), 0u);
}

// A complete program as controllers take it, made from public posts and packages.
TEST_F(MakersGrammars, krl) {
  const std::string program = withCrLf(R"(&ACCESS RVP
&REL 1
DEF PRINT_A ( )
;FOLD INI
GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )
INTERRUPT ON 3
BAS (#INITMOV,0 )
;ENDFOLD
$BASE={X 400,Y -100,Z 20,A 0,B 0,C 0}
$LOAD={M 1.2,CM {X 0,Y 0,Z 50,A 0,B 0,C 0},J {X 0,Y 0,Z 0}}
$IPO_MODE=#BASE
$APO.CDIS=0.5
PTP {A1 0,A2 -90,A3 90,A4 0,A5 90,A6 0}
LIN {X 0,Y 0,Z 0.3,A 0,B 0,C 180}
TRIGGER WHEN DISTANCE=0 DELAY=0 DO $OUT[1]=TRUE
LIN {X 40,Y 0,Z 0.3,A 0,B 0,C 180} C_DIS
$OUT[1]=FALSE
END
)");
  const std::initializer_list<Damage> all = {{"DEF PRINT_A ( )", "DEF PRINT_A"},
                                             {"LIN {X 0,Y 0", "LIN {X 0 Y 0"},
                                             {"C 180} C_DIS", "C 180 C_DIS"},
                                             {"$OUT[1]=FALSE", "$OUT[1]:=FALSE"},
                                             {"DELAY=0 DO", "DELAY=0"},
                                             {"DEF PRINT_A", "DEF PRINT_A_NAME_LONGER_THAN_24"},
                                             {"$APO.CDIS=0.5\r\n", "$APO.CDIS=0.5\n"}};
  expectFound(test::wrongKrlLine, program, all);
  for (const Dialect& d : dialects())
    if (d.id == "krl") {
      for (const std::string& text : written("krl"))
        EXPECT_EQ(test::wrongKrlLine(text), 0u) << text.substr(0, 3000);
    }
}

TEST_F(MakersGrammars, anExtruderAsAnExternalAxis) {
  randomFor(findDialect("rapid"), 3, 400);
  process_.retractMm = 1.5;
  ProgramInput in = input();
  in.options.own[std::string(kExtruderOption)] = std::string(kAxisExtruder);
  const Grammar rapid = test::wrongRapidLine, krl = test::wrongKrlLine;
  for (const auto& [format, extension, wrongLine] :
       {std::tuple("rapid", ".mod", rapid), std::tuple("krl", ".src", krl)}) {
    std::size_t texts = 0;
    for (const plan::ProgramFile& file : writeProgram(format, in).files)
      if (file.name.ends_with(extension)) {
        EXPECT_EQ(wrongLine(file.text), 0u) << file.name << "\n" << file.text.substr(0, 3000);
        ++texts;
      }
    EXPECT_GT(texts, 0u);
  }
}

} // namespace
} // namespace voluta::program
