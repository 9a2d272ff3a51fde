// RAPID whose flow follows the TCP's real speed (TriggSpeed).
#include "program_fixture.h"

#include "program/dialect.h"

namespace voluta::program {
namespace {

using RapidSpeed = test::Programs;

std::string crLf(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

std::string module(const std::string& body) {
  return crLf("MODULE m\n"
              "PERS tooldata t1:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,80],[1,0,0,0],0,0,0]];\n"
              "PERS wobjdata w1:=[FALSE,TRUE,\"\",[[400,0,0],[1,0,0,0]],[[0,0,10],[1,0,0,0]]];\n"
              "VAR triggdata t2;\n"
              "PROC main()\n"
              "ConfL\\Off; ConfJ\\Off;\n"
              "SetDO doExtruder,0;\n"
              "SetAO aoFlow,0;\n" +
              body +
              "SetDO doExtruder,0;\n"
              "SetAO aoFlow,0;\n"
              "ENDPROC\nENDMODULE\n");
}

void expectSound(const plan::ReadProgram& program) {
  EXPECT_TRUE(program.complete);
  for (const plan::ProgramDefect& d : program.defects)
    ADD_FAILURE() << d.file << ":" << d.line << ": " << voluta::base::english(d.reason);
}

// By the speed an amount follows from the way: scale, way and full flow, whatever the time.
TEST_F(RapidSpeed, readsAFlowThatFollowsTheSpeed) {
  const auto pose = [](const std::string& x) {
    return "[[" + x + ",2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
  };
  const std::string tail = ",fine,t1\\WObj:=w1;\n";
  const auto read = [](const std::string& text) {
    process::Process process;
    process.maxFlowMm3PerS = 40.0;
    return readProgram("rapid", {{"m.mod", text}}, process::Tooling(process));
  };
  const std::string text =
      module("MoveL " + pose("1") + ",v100" + tail +
             "SetDO doExtruder,1;\nTriggSpeed t2, 0\\Start, 0, aoFlow, 0.005;\n"
             "TriggL " +
             pose("3") + ",v20,t2" + tail + "MoveL " + pose("3.5") + ",v100" + tail +
             "SetAO aoFlow,0.25;\nMoveL " + pose("4") + ",v20" + tail);
  const auto program = read(text);
  expectSound(program);
  ASSERT_EQ(program.motions.size(), 4u);
  EXPECT_FALSE(program.motions[0].extruding);
  EXPECT_NEAR(program.motions[1].volumeMm3, 0.005 * 40.0 * 2.0, 1e-12);
  EXPECT_NEAR(program.motions[1].flowMm3PerS, 0.005 * 40.0 * 20.0, 1e-12);
  EXPECT_NEAR(program.motions[2].volumeMm3, 0.005 * 40.0 * 0.5, 1e-12);
  EXPECT_LT(program.motions[3].volumeMm3, 0.0) << "a rate again";
  EXPECT_EQ(program.motions[3].flowMm3PerS, 10.0);
  const auto bad = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    return read(changed);
  };
  for (const auto& [from, to] : {std::pair{"t2, 0\\Start", "t2, 1\\Start"},
                                 {", 0, aoFlow", ", 0.1, aoFlow"},
                                 {", aoFlow, 0.005", ", aoFan, 0.005"},
                                 {"0.005", "-0.005"},
                                 {"0.005", "0"},
                                 {"0.005", "9e9"},
                                 {"VAR triggdata t2;", "VAR triggdata t3;"}})
    EXPECT_FALSE(bad(from, to).defects.empty()) << to;
  // More than the output can represent.
  EXPECT_FALSE(bad("0.005", "0.06").defects.empty());
}

TEST_F(RapidSpeed, flowBySpeedDepositsThePlannedVolume) {
  appendRandom(8, 1500);
  ProgramInput in = input();
  in.options.own["rapidFlow"] = std::string("speed");
  const plan::Program program = writeProgram("rapid", in);
  const plan::ReadProgram back = readProgram("rapid", program.files, process::Tooling(process_));
  expectSound(back);
  ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
  std::size_t events = 0;
  for (std::size_t i = 1; i < back.motions.size(); ++i) {
    const double volume = trajectory_.extrudedMm3[i] - trajectory_.extrudedMm3[i - 1];
    EXPECT_EQ(back.motions[i].extruding, volume > 0.0);
    if (volume > 0.0) {
      EXPECT_NEAR(back.motions[i].volumeMm3, volume, 1e-3 * volume) << i;
    }
  }
  const std::string& text = program.files[0].text;
  for (std::size_t at = text.find("TriggSpeed tFlow"); at != std::string::npos;
       at = text.find("TriggSpeed tFlow", at + 1))
    ++events;
  EXPECT_GT(events, 500u);
  EXPECT_EQ(text.find("TriggEquip"), std::string::npos);
}

} // namespace
} // namespace voluta::program
